// SPDX-License-Identifier: GPL-3.0-or-later
/// Closest points on a triangle mesh.
#pragma once

#include "TriangleMesh.h"

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
class SurfaceProjection
{
public:
  explicit SurfaceProjection(const TriangleMesh& mesh);
  ~SurfaceProjection();
  SurfaceProjection(const SurfaceProjection&) = delete;
  SurfaceProjection& operator=(const SurfaceProjection&) = delete;

  SurfacePoint closest(const Eigen::Vector3d& point) const;

private:
  struct Tree;
  const TriangleMesh& Mesh;
  std::unique_ptr<Tree> Boxes;
};

} // namespace flattening
