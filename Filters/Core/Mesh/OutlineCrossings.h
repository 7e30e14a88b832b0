// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether the outline of a flat map crosses itself, decided exactly.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace flattening
{

/// An edge in the plane, by its two different vertices.
using FlatEdge = std::array<int, 2>;

/// The edges of the closed polygon through the vertices of @p loop.
std::vector<FlatEdge> outlineEdges(const std::vector<int>& loop);

/// Whether two of @p edges at @p positions (n x 2, finite) have a point in common beside the vertex that
/// they share. It is exact for the given doubles (CGAL's filtered predicates).
bool edgesCross(const Points2& positions, const std::vector<FlatEdge>& edges);

/// Which of these edges have a point in common with another one beside a vertex that they share, as
/// flags (one per edge).
std::vector<char> crossingEdges(const Points2& positions, const std::vector<FlatEdge>& edges);

/// Whether the closed polygon through the vertices of @p loop is simple: none of its edges cross. A flat
/// map of a disk whose faces are all positively oriented and whose outline is simple is one-to-one.
bool isSimpleOutline(const Points2& positions, const std::vector<int>& loop);

} // namespace flattening
