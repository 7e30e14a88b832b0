// SPDX-License-Identifier: GPL-3.0-or-later
/// Closest points on a triangle mesh.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <array>
#include <memory>

namespace flattening
{

/// A point of a mesh.
struct SurfacePoint
{
  int Face; ///< row of the mesh's faces
  Eigen::Vector3d Position = Eigen::Vector3d::Zero();
  std::array<double, 3> Weights; ///< barycentric, >= 0, sum 1, in the order of the face's vertices
};

/// Finds the closest points of a mesh with a tree of boxes (CGAL AABB tree). The mesh must outlive it.
class ClosestPointTree
{
public:
  /// With @p progress the tree is complete afterwards, and an abort does not wait for it; otherwise the
  /// first query builds a part of it. @throws Cancelled.
  explicit ClosestPointTree(const TriangleMesh& mesh, const ProgressCallback& progress = {});
  ~ClosestPointTree();
  ClosestPointTree(const ClosestPointTree&) = delete;
  ClosestPointTree& operator=(const ClosestPointTree&) = delete;

  /// Tells whether the squares of distances to @p point are finite doubles.
  static bool canSearch(const Eigen::Vector3d& point);

  /// The point of the mesh closest to @p point. @throws InvalidInput unless canSearch().
  SurfacePoint closest(const Eigen::Vector3d& point) const;

private:
  struct Tree;
  const TriangleMesh& Mesh;
  std::shared_ptr<Tree> Boxes; ///< shared with the thread that builds it and may outlive this object
};

} // namespace flattening
