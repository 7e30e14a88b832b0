// SPDX-License-Identifier: GPL-3.0-or-later
/// Faces of a surface that pass through each other.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace flattening
{

/// A triangle in space that knows which of its corners it shares with others.
struct PlacedTriangle
{
  std::array<int, 3> Vertices;           ///< indices; the same index means the same point
  std::array<Eigen::Vector3d, 3> Points; ///< finite

  /// The smallest box around the triangle.
  Eigen::AlignedBox3d box() const
  {
    Eigen::AlignedBox3d box(this->Points[0]);
    return box.extend(this->Points[1]).extend(this->Points[2]);
  }
};

/// Whether two triangles have a point in common beside the vertices and the edge that they share by
/// index. Two triangles with the same three vertices have. Exact predicates decide. Precondition: no
/// triangle has a vertex twice.
bool intersect(const PlacedTriangle& a, const PlacedTriangle& b);

/// Pairs of indices (i < j, sorted) of the triangles that intersect. A triangle that has a vertex twice
/// intersects nothing.
std::vector<std::pair<int, int>> intersectingPairs(const std::vector<PlacedTriangle>& triangles,
  const ProgressCallback& progress = {});

/// Pairs of indices (i in @p some, 0 <= j < @p count, sorted) of a box and the box @p boxOf(j) that
/// overlap or touch. Nothing if there are more than @p most, without the memory and the time for more.
/// Several threads call @p boxOf.
std::optional<std::vector<std::pair<int, int>>> fewOverlappingBoxes(
  const std::vector<Eigen::AlignedBox3d>& some,
  int count,
  const std::function<Eigen::AlignedBox3d(int)>& boxOf,
  std::size_t most);

/// The number of pairs (i in @p some, j in @p all) of triangles whose boxes overlap or touch and for
/// which @p counts returns true, in any order and in several threads.
std::size_t countOverlappingBoxes(const std::vector<PlacedTriangle>& some,
  const std::vector<PlacedTriangle>& all,
  const std::function<bool(int, int)>& counts);

/// The number of pairs of faces that intersect, the ones that CGAL's self_intersections finds. A face
/// that has a vertex twice intersects nothing. Precondition: no other face is without area.
std::size_t countSelfIntersections(const TriangleMesh& mesh, const ProgressCallback& progress = {});

/// Intersecting pairs of faces, and their number.
struct FewPairs
{
  std::size_t Count = 0;
  std::vector<std::pair<int, int>> Pairs; ///< i < j, sorted; not all of them if there are too many
};

/// The pairs that countSelfIntersections counts, all of them if there are at most @p most.
FewPairs fewSelfIntersections(const TriangleMesh& mesh,
  std::size_t most,
  const ProgressCallback& progress = {});

/// The same pairs, but only those with a face of @p some in them (ascending).
FewPairs fewIntersectionsOf(const TriangleMesh& mesh,
  const std::vector<int>& some,
  std::size_t most,
  const ProgressCallback& progress = {});

/// For each group of faces of @p mesh the number of pairs of a face in it and any other face of the mesh
/// that intersect; a pair within the group counts twice.
std::vector<int> intersectionsPerGroup(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& groups);

} // namespace flattening
