// SPDX-License-Identifier: GPL-3.0-or-later
/// The faces of a flat map whose areas are off, and the vertices near them.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Mesh/VertexFaces.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// The faces whose area is off by more than a tolerance.
struct WrongFaces
{
  /// @p areaRatios (m): signed areas over their targets. @p tolerance > 0, relative.
  WrongFaces(const Eigen::VectorXd& areaRatios, double tolerance);

  std::vector<int> Faces; ///< in ascending order
  double Share = 0.0;     ///< their share of all faces
  double Distance = 0.0;  ///< the sum of the logarithms of their area ratios, absolute values
};

/// The share of the faces whose flat area, as a part of the whole map, differs from their target (m, >
/// 0) by more than @p tolerance of it.
double shareOfWrongFaces(const Points2& positions,
  const FaceMatrix& faces,
  const Eigen::VectorXd& targets,
  double tolerance);

/// Marks the vertices (n) of @p wrong and of @p rings rings of faces around them. @p facesOf holds
/// @p faces.
std::vector<char> verticesNear(const std::vector<int>& wrong,
  const FaceMatrix& faces,
  const VertexFaces& facesOf,
  int rings);

} // namespace flattening
