// SPDX-License-Identifier: GPL-3.0-or-later
/// Intersections between the faces of a surface that changes in places.
#pragma once

#include "Handles/HalfedgeSurface.h"

#include <Eigen/Core>

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace flattening
{

/// Faces that shall replace some of a surface's: those listed go, the others come. Faces name vertices
/// of the surface or of @p Places, which also holds the vertices that move.
struct FaceReplacement
{
  std::map<int, Eigen::Vector3d> Places;
  std::vector<int> Replaced; ///< ascending
  std::vector<std::array<int, 3>> Faces;
};

/// Counts as CGAL's self_intersections does: faces that share a vertex intersect if they have another
/// point in common, faces that share an edge if they overlap in their plane. Exact.
class FaceIntersections
{
public:
  /// Puts the boxes of all faces into a tree (Boost rtree). The surface must outlive this.
  explicit FaceIntersections(const HalfedgeSurface& surface);
  ~FaceIntersections();
  FaceIntersections(const FaceIntersections&) = delete;
  FaceIntersections& operator=(const FaceIntersections&) = delete;

  /// Pairs of intersecting faces of which at least one is new. Stops soon after more than @p enough.
  int countNew(const FaceReplacement& replacement, int enough) const;

  /// Pairs of intersecting faces of which at least one is listed (ascending).
  int count(const std::vector<int>& faces) const;

  /// To be called before the listed faces of the surface change, and after.
  void remove(const std::vector<int>& faces);
  void insert(const std::vector<int>& faces);

private:
  struct Tree;
  const HalfedgeSurface& Surface;
  std::unique_ptr<Tree> Boxes;
};

} // namespace flattening
