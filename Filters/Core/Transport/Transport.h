// SPDX-License-Identifier: GPL-3.0-or-later
/// Semi-discrete optimal mass transport from a convex domain to weighted sites (paper, Algorithm 1).
#pragma once

#include "Base/Progress.h"
#include "Transport/PowerDiagram.h"

namespace flattening
{

/// When the transport ends.
struct TransportOptions
{
  double Tolerance = 1e-6;     ///< greatest cell error max_i |A_i - nu_i| / nu_i accepted, in (0, 1)
  int MaximumIterations = 500; ///< most Newton steps, > 0
};

/// The power weights of a transport, and how they were found.
struct TransportResult
{
  PowerDiagram::Weights Weights; ///< one per site
  int NewtonIterations = 0;      ///< number of Newton steps
  double MaxCellError = 0.0;     ///< max_i |A_i - nu_i| / nu_i
};

/// Finds the weights for which every cell of @p diagram has its target area, by damped Newton iteration
/// on the convex energy (paper, equations 8 to 10, with the sides' lengths divided by twice the sites'
/// distance; docs/mathematics.md, "Optimal transport"). A step is accepted by the rule of Kitagawa,
/// Merigot and Thibert (2016), which converges from any start without empty cells. A step that it
/// refuses is corrected, by simplified Newton steps with the same factor, before it is shortened: where
/// a few cells would vanish, their neighbours give way. The targets are approached geometrically, from
/// the areas at the start to @p targets, so that most first trial steps are accepted. Weights and steps
/// have twice the precision of double, and so has the solution of the linear system, by iterative
/// refinement: the cells of sites that nearly coincide depend on digits of the weights that doubles do
/// not have.
///
/// @param diagram  afterwards it has the cells of the result
/// @param targets  nu, > 0, with the domain's area as their sum (n)
/// @param startWeights  power weights of an earlier transport of the same sites (n), or empty; see
/// initialWeights()
/// @throws ConvergenceError if the tolerance is not met, Cancelled.
TransportResult transportNewton(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  const TransportOptions& options = {},
  const ProgressCallback& progress = {},
  const Eigen::VectorXd& startWeights = {});

} // namespace flattening
