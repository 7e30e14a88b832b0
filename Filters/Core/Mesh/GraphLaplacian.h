// SPDX-License-Identifier: GPL-3.0-or-later
/// Positions in the plane as the equilibrium of springs between points: the Dirichlet problem of a
/// graph's Laplacian.
#pragma once

#include "Base/Progress.h"
#include "Base/SparseFactorization.h"
#include "Mesh/ComplexPositions.h"

#include <vector>

namespace flattening
{

struct Spring
{
  int From;
  int To;
  double Weight; ///< > 0
};

/// Moves all points but the @p fixed ones (per point; the others must hang on these by springs) to where
/// the springs are in equilibrium. Around a convex boundary no triangle is turned over (Tutte 1963,
/// Floater 1997).
/// @param order  of elimination, of points that need not be all; where it does not serve another one is
///               found, which takes time
/// @throws ConvergenceError if the linear system cannot be factored; Cancelled.
void relaxSprings(const std::vector<Spring>& springs,
  const std::vector<char>& fixed,
  ComplexVector& position,
  const EliminationOrder& order = {},
  const ProgressCallback& progress = {});

} // namespace flattening
