// SPDX-License-Identifier: GPL-3.0-or-later
/// A disk with fewer vertices in place of one with many.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// Some of the vertices of a surface that is a disk, with triangles between them. Its flat maps stand
/// for those of the surface: they have the same outline, and carried() gives the places of the other
/// vertices.
struct CoarseDisk
{
  /// The vertices of the surface that it has (k): those of the boundary in their order, then inner ones.
  std::vector<int> Vertices;
  FaceMatrix Faces;            ///< rows of Vertices
  Eigen::VectorXd Targets;     ///< per face: the sum of the targets of the surface that it covers
  Eigen::MatrixX3d Cotangents; ///< of the angles that its faces have on the surface, on average
  std::vector<int> FaceOf;     ///< per vertex of the surface: the face that it lies in
  Eigen::MatrixX3d Weights;    ///< the same: its barycentric coordinates there

  /// The map of the surface (n x 2) for a flat map of this disk (k x 2): every vertex keeps its
  /// barycentric coordinates, and those of this disk are where they are in its map, without rounding.
  Points2 carried(const Points2& positions) const;
};

/// Takes all vertices of the boundary, and inner ones that are about as far from each other, along edges
/// of the surface, as their number allows, and closer near the boundary. The faces are those of a
/// constrained Delaunay triangulation in @p chart. The shape of a face is measured by the metric of the
/// surface, averaged over the parts of faces of the surface that it covers there.
/// @param loop      the boundary vertices of @p surface
/// @param chart     a one-to-one map of the surface (n x 2), near a conformal one
/// @param targets   the areas that the faces of the surface should have (m, >= 0)
/// @param vertices  about how many inner vertices to take, >= 1
/// @throws Cancelled.
CoarseDisk coarseDisk(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& chart,
  const Eigen::VectorXd& targets,
  int vertices,
  const ProgressCallback& progress = {});

} // namespace flattening
