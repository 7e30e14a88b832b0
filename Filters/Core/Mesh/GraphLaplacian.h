// SPDX-License-Identifier: GPL-3.0-or-later
/// Positions in the plane as the equilibrium of springs between points: the Dirichlet problem of a
/// graph's Laplacian.
#pragma once

#include "Base/Progress.h"
#include "Mesh/ComplexPositions.h"

#include <vector>

namespace flattening
{

/// A spring of rest length 0 between two points.
struct Spring
{
  int From;
  int To;
  double Weight; ///< stiffness > 0
};

/// Moves all points except the @p fixed ones (one flag per point) to where the springs are in
/// equilibrium. Springs must connect every point with a fixed one. Within a convex boundary no triangle
/// of a planar triangulation is flipped (Tutte 1963, Floater 1997).
/// @throws ConvergenceError if the linear system cannot be factored; Cancelled.
void relaxSprings(const std::vector<Spring>& springs,
  const std::vector<char>& fixed,
  ComplexVector& position,
  const ProgressCallback& progress = {});

} // namespace flattening
