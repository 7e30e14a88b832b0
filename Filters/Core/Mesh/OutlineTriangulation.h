// SPDX-License-Identifier: GPL-3.0-or-later
/// Triangles on both sides of the outline of a flat map.
#pragma once

#include "Base/Progress.h"
#include "Mesh/OutlineCrossings.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace flattening
{

/// The constrained Delaunay triangulation of a simple polygon and of points inside it (CGAL). It fills
/// the convex hull of the polygon.
class OutlineTriangulation
{
public:
  /// @p positions  n x 2, finite
  /// @p outline    the edges of the polygon, of which none may cross
  /// @p inner      other points, by their rows; no two points may coincide
  /// @throws Cancelled.
  OutlineTriangulation(const Points2& positions,
    const std::vector<FlatEdge>& outline,
    const std::vector<int>& inner = {},
    const ProgressCallback& progress = {});
  ~OutlineTriangulation();
  OutlineTriangulation(const OutlineTriangulation&) = delete;
  OutlineTriangulation& operator=(const OutlineTriangulation&) = delete;

  /// The triangles inside and those outside the polygon (k x 3, rows of the positions,
  /// counter-clockwise), in an order that depends on the triangles alone.
  const FaceMatrix& inside() const { return this->Inside; }
  const FaceMatrix& outside() const { return this->Outside; }

  /// The row in inside() of a triangle that has @p point; -1 if it lies outside the polygon.
  /// @param near  the row of a triangle near the point, from which it is found fast
  int insideAt(const Eigen::Vector2d& point, int near) const;

private:
  struct Triangulation;
  std::unique_ptr<Triangulation> Delaunay;
  FaceMatrix Inside;
  FaceMatrix Outside;
};

} // namespace flattening
