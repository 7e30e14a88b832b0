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

/// Where a point lands on a mesh.
struct SurfacePoint
{
  int Face;
  Eigen::Vector3d Position;
  std::array<double, 3> Weights; ///< barycentric, >= 0, sum 1, in the order of the face's vertices
};

/// Answers closest-point queries with a tree of boxes (CGAL AABB tree); the mesh must outlive it.
class ClosestPointTree
{
public:
  /// With @p progress the tree is built at once, which an abort does not wait for; else by the first
  /// query.
  explicit ClosestPointTree(const TriangleMesh& mesh, const ProgressCallback& progress = {});
  ~ClosestPointTree();
  ClosestPointTree(const ClosestPointTree&) = delete;
  ClosestPointTree& operator=(const ClosestPointTree&) = delete;

  SurfacePoint closest(const Eigen::Vector3d& point) const;

private:
  struct Tree;
  const TriangleMesh& Mesh;
  std::shared_ptr<Tree> Boxes; ///< shared with the call that builds it, which an abort leaves behind
};

} // namespace flattening
