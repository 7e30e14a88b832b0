// SPDX-License-Identifier: GPL-3.0-or-later
/// Discrete Ricci (Yamabe) flow: finds conformal factors that give every vertex its target curvature.
#pragma once

#include "Base/Errors.h"
#include "Base/Progress.h"
#include "Base/SparseFactorization.h"
#include "Intrinsic/IntrinsicTriangulation.h"

#include <string>
#include <vector>

namespace flattening
{

struct RicciFlowOptions
{
  /// Greatest accepted difference between an angle sum and its target (radians). Range (0, 1e-3].
  double Tolerance = 1e-11;
  int MaximumIterations = 60; ///< greatest number of Newton steps, >= 0
};

/// The flow stopped before its tolerance was met.
struct RicciFlowStopped : ConvergenceError
{
  RicciFlowStopped(const std::string& message, int newtonIterations, long long excessiveFlips)
    : ConvergenceError(message)
    , NewtonIterations(newtonIterations)
    , ExcessiveFlips(excessiveFlips)
  {
  }
  int NewtonIterations;     ///< steps until then
  long long ExcessiveFlips; ///< flips until then of evaluations that flipped too many edges
};

struct RicciFlowResult
{
  /// The logarithmic factors u, one per vertex: an edge from vertex i to vertex j, of length l_ij in the
  /// triangulation, gets the flat length l_ij exp((u_i + u_j) / 2).
  IntrinsicTriangulation::Factors LogFactors;
  int NewtonIterations = 0;
  long long Flips = 0;
  double MaxCurvatureError = 0.0; ///< radians
  /// The vertices in the order in which the last Hessian was eliminated, which serves for the layout,
  /// too; empty if there is none.
  EliminationOrder Order;
};

/// Minimises the convex energy whose gradient is (target angle sum - angle sum) by Newton's method with
/// the cotangent Laplacian as Hessian. Edges are flipped so that the triangulation stays Delaunay at the
/// current factors, and no triangle away from the boundary can degenerate. The flips are Ptolemaic: the
/// length of the new edge follows from the five edges of the two faces by Ptolemy's relation, that the
/// product of the two diagonals is the sum of the products of opposite sides. The relation holds at all
/// factors alike, so that a flip does not change the conformal class.
/// (Springborn, Schroeder, Pinkall 2008; Gu, Luo, Sun, Wu 2018; Gillespie, Springborn, Crane 2021; see
/// docs/mathematics.md, "Conformal map".)
///
/// @param triangulation  changed by flips only
/// @param targetAngles   wanted angle sum per vertex (radians): 2 pi inside, pi on a straight boundary
/// @param fixed          1 for vertices whose u keeps its value in @p start; at least one vertex
/// @param start          initial u, one per vertex
/// @throws RicciFlowStopped if the tolerance is not met or a boundary triangle degenerates; Cancelled.
RicciFlowResult discreteRicciFlow(IntrinsicTriangulation& triangulation,
  const Eigen::VectorXd& targetAngles,
  const std::vector<char>& fixed,
  const IntrinsicTriangulation::Factors& start,
  const RicciFlowOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
