// SPDX-License-Identifier: GPL-3.0-or-later
/// Discrete Ricci (Yamabe) flow: conformal factors that give every vertex its target curvature.
#pragma once

#include "Base/Progress.h"
#include "Base/SparseFactorization.h"
#include "Intrinsic/IntrinsicTriangulation.h"

#include <vector>

namespace flattening
{

struct RicciFlowOptions
{
  /// Greatest |angle sum - target| accepted, radians. Range (0, 1e-3].
  double Tolerance = 1e-11;
  int MaximumIterations = 60;
};

struct RicciFlowResult
{
  IntrinsicTriangulation::Factors LogFactors; ///< u of l_ij exp((u_i + u_j) / 2), one per vertex
  int NewtonIterations = 0;
  int Flips = 0;
  double MaxCurvatureError = 0.0; ///< radians
  EliminationOrder Elimination;   ///< of vertices, by the last factorization, for the layout to use
};

/// Minimises the convex energy whose gradient is (target angle sum - angle sum) by Newton's method with
/// the cotangent Laplacian as Hessian. The triangulation is kept Delaunay at the current factors by
/// Ptolemaic flips, so no triangle away from the boundary can degenerate on the way.
/// (Springborn, Schroeder, Pinkall 2008; Gu, Luo, Sun, Wu 2018; Gillespie, Springborn, Crane 2021.)
///
/// @param triangulation  changed by flips only
/// @param targetAngles   wanted angle sum per vertex (radians): 2 pi inside, pi on a straight boundary
/// @param fixed          1 where u keeps its value in @p start; at least one vertex
/// @param start          u to begin with, one per vertex
/// @throws ConvergenceError if the tolerance is not met or a boundary triangle degenerates.
RicciFlowResult discreteRicciFlow(IntrinsicTriangulation& triangulation,
  const Eigen::VectorXd& targetAngles,
  const std::vector<char>& fixed,
  const IntrinsicTriangulation::Factors& start,
  const RicciFlowOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
