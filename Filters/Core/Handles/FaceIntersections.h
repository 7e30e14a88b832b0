// SPDX-License-Identifier: GPL-3.0-or-later
/// Counts the intersections between the faces of a surface that changes in few places at a time.
#pragma once

#include "Handles/HalfedgeSurface.h"
#include "Mesh/BoxTree.h"
#include "Mesh/SelfIntersections.h"

#include <Eigen/Core>

#include <array>
#include <map>
#include <vector>

namespace flattening
{

/// Faces that take the place of some faces of a surface. Their vertices are vertices of the surface or
/// keys of Positions.
struct FaceReplacement
{
  std::map<int, Eigen::Vector3d> Positions; ///< of new vertices and of vertices that move
  std::vector<int> Replaced;                ///< faces that go, ascending
  std::vector<std::array<int, 3>> Faces;    ///< faces that come
};

/// The listed faces of a surface, and the new faces of a replacement.
std::vector<PlacedTriangle> trianglesOf(const HalfedgeSurface& surface, const std::vector<int>& faces);
std::vector<PlacedTriangle> trianglesOf(const HalfedgeSurface& surface,
  const FaceReplacement& replacement);

/// Counts pairs of faces that intersect by the rules of intersect(): faces that share a vertex intersect
/// if they have another point in common, faces that share an edge if they overlap in their plane. Exact.
class FaceIntersections
{
public:
  /// Puts the boxes of all faces into a tree. The surface must outlive this.
  explicit FaceIntersections(const HalfedgeSurface& surface);

  /// Pairs of intersecting faces of which at least one is new. Stops soon after more than @p enough.
  int countNew(const FaceReplacement& replacement, int enough) const;

  /// Pairs of intersecting faces of which at least one is listed (ascending).
  int count(const std::vector<int>& faces) const;

  /// Must be called before the listed faces of the surface change.
  void remove(const std::vector<int>& faces);
  /// Must be called after the listed faces of the surface have changed or were added.
  void insert(const std::vector<int>& faces);

private:
  int count(const std::vector<PlacedTriangle>& triangles,
    const std::vector<int>& leftOut,
    int enough) const;

  const HalfedgeSurface& Surface;
  BoxTree Boxes; // of the faces
};

} // namespace flattening
