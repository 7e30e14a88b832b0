// SPDX-License-Identifier: GPL-3.0-or-later
/// Functions that the area-restoring flows of a flat disk share.
#pragma once

#include "Base/SparseFactorization.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening::benchmarks
{

using FaceVectors = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>; ///< m x 2

struct FlowResult
{
  Points2 Positions;
  int Steps = 0;
  bool Converged = false; ///< before the time was over and the steps became too short
};

/// The stiffness matrix of linear elements on a flat mesh: half the cotangents (n x n, lower triangle).
SparseMatrix stiffness(const Points2& positions, const FaceMatrix& faces);

/// The gradient of a function of the vertices on every face.
FaceVectors faceGradients(const Points2& positions,
  const FaceMatrix& faces,
  const Eigen::VectorXd& values);

/// Mean of the faces around each vertex, by their areas (n x 2).
FaceVectors vertexMeans(const FaceMatrix& faces,
  const FaceVectors& values,
  const Eigen::VectorXd& areas,
  int vertexCount);

/// Moves the vertices by @p velocity for the longest of @p time, @p time / 2, ... down to @p shortest
/// after which every face has more than a fifth of its area; boundary vertices stay on the unit circle.
/// @return the time; 0 if even the shortest is too long, and then nothing is moved.
double advance(Points2& positions,
  const FaceVectors& velocity,
  double time,
  double shortest,
  const FaceMatrix& faces,
  const std::vector<int>& boundary);

} // namespace flattening::benchmarks
