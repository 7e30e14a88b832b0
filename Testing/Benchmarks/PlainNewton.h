// SPDX-License-Identifier: GPL-3.0-or-later
/// The damped Newton iteration for semi-discrete transport as published, without accelerations.
#pragma once

#include "Transport/PowerDiagram.h"

namespace flattening::benchmarks
{

struct PlainNewtonResult
{
  int Steps = 0;
  double CellError = 0.0; ///< max_i |A_i - nu_i| / nu_i
  bool Converged = false; ///< to the tolerance, within the time
};

/// Kitagawa, Merigot, Thibert, "Convergence of a Newton algorithm for semi-discrete optimal transport"
/// (2016), Algorithm 1: from zero weights; every step solves with a factorization of its own; its length
/// is the first of 1, 1/2, 1/4 ... for which no cell is below half of the least area at the start and of
/// the least target, and the norm of the error falls by the factor 1 - length / 2. Each trial is a power
/// diagram.
/// @p targets (n) > 0, sum = area of the domain. Ends after @p seconds of processor time.
PlainNewtonResult plainNewton(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  double tolerance,
  double seconds);

} // namespace flattening::benchmarks
