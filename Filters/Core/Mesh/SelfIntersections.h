// SPDX-License-Identifier: GPL-3.0-or-later
/// Faces of a surface that pass through each other.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace flattening
{

/// A triangle in space that knows which of its corners it shares with others.
struct PlacedTriangle
{
  std::array<int, 3> Vertices;
  std::array<Eigen::Vector3d, 3> Points; ///< finite
};

/// Whether two triangles have a point in common beside the vertices and the edge that they share by
/// index: exact predicates. Two with the same three vertices do.
bool intersect(const PlacedTriangle& a, const PlacedTriangle& b);

/// Pairs of indices (i < j, sorted) of the triangles that intersect.
std::vector<std::pair<int, int>> intersectingPairs(const std::vector<PlacedTriangle>& triangles,
  const ProgressCallback& progress = {});

/// Pairs of indices (i in @p some, j in @p all, sorted) of the triangles whose boxes overlap.
std::vector<std::pair<int, int>> overlappingBoxes(const std::vector<PlacedTriangle>& some,
  const std::vector<PlacedTriangle>& all);

/// Pairs of faces (smaller index first, sorted) that intersect, as CGAL self_intersections finds them.
/// Faces without area must have been repaired.
std::vector<std::pair<int, int>> selfIntersections(const TriangleMesh& mesh,
  const ProgressCallback& progress = {});

} // namespace flattening
