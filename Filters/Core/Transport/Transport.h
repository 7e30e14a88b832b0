// SPDX-License-Identifier: GPL-3.0-or-later
/// Semi-discrete optimal mass transport from the unit disk to weighted sites (paper, Algorithm 1).
#pragma once

#include "Base/Progress.h"
#include "Transport/PowerDiagram.h"

namespace flattening
{

struct TransportOptions
{
  /// Greatest max_i |A_i - nu_i| / nu_i accepted. Range (0, 1).
  double Tolerance = 1e-6;
  int MaximumIterations = 500;
  /// Power weights of a transport of the same sites to begin with (n), or empty. They are taken if no
  /// cell is off by more than a decade, or if they are nearer to the targets than the usual starts.
  Eigen::VectorXd StartWeights;
};

struct TransportResult
{
  PowerDiagram::Weights Weights; ///< power weights, one per site
  int NewtonIterations = 0;
  double MaxCellError = 0.0; ///< max_i |A_i - nu_i| / nu_i
};

/// Finds the weights for which every cell of @p diagram has its target area, by damped Newton iteration
/// on the convex energy (paper, equations 8 to 10, with the sides' lengths divided by twice the sites'
/// distance). A step is accepted by the rule of Kitagawa, Merigot and Thibert (2016), which converges
/// from any start without empty cells; the few cells that a step would leave nearly empty get weight of
/// their own first (see feedVanishingCells). The start is the best of some convex potentials, one of
/// which opens places with far too many sites (see openingPotential). The targets are approached
/// geometrically, from the areas at the start to @p targets, so that most first trial steps are
/// accepted. Weights and steps have twice the precision of double, and so has the solution of the linear
/// system, by iterative refinement: the cells of sites that nearly coincide depend on them in digits
/// that doubles do not have.
///
/// @param diagram  its cells are those of the result afterwards
/// @param targets  nu, > 0, sum = area of the unit disk (n)
/// @throws ConvergenceError if the tolerance is not met, Cancelled.
TransportResult transportNewton(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  const TransportOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
