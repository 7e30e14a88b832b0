// SPDX-License-Identifier: GPL-3.0-or-later
/// Triangles with two corners that are all but one point.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace flattening
{

/// The shortest edge of a face that is kept, as share of its longest: below, rounding decides its shape.
constexpr double SmallestEdgeShare = 1e-9;

struct CollapsedNeedles
{
  int Vertices = 0; ///< joined to another one
  int Faces = 0;    ///< gone with an edge
};

/// Collapses the edges that are shorter than SmallestEdgeShare of the longest edge of a face beside
/// them, until there is none: of the vertices joined, the one with the smallest index stays, where it
/// is.
/// @p faces (no repeated vertices) and @p origins (what each face is a part of) change together; several
/// faces may then have the same vertices.
CollapsedNeedles collapseNeedles(const Points3& vertices,
  std::vector<std::array<int, 3>>& faces,
  std::vector<int>& origins);

} // namespace flattening
