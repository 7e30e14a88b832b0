// SPDX-License-Identifier: GPL-3.0-or-later
/// How far the vertices of an outline may move without a crossing.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// For every vertex of the closed polygon through @p loop at @p positions (n x 2), which is simple, a
/// distance > 0: while no vertex moves by as much, two edges of different groups do not meet, nor two
/// edges of group -1. @p groups holds the group of every edge; edge k runs from vertex k of the loop to
/// the next one. The distance is a little less than half of that between the edges at the vertex and the
/// nearest edge of another group, and at most the length of these edges.
///
/// Two edges without a common vertex meet only if points of both have moved by half of their distance,
/// and a point of an edge moves at most as far as the farther of its ends. Two neighbouring edges meet
/// beside their vertex only if the far end of one has come to the other.
std::vector<double> outlineReach(const Points2& positions,
  const std::vector<int>& loop,
  const std::vector<int>& groups);

} // namespace flattening
