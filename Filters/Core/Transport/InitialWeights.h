// SPDX-License-Identifier: GPL-3.0-or-later
/// Power weights from which the transport starts: they leave no cell empty.
#pragma once

#include "Base/Progress.h"
#include "Transport/PowerDiagram.h"

namespace flattening
{

/// The weights w = r^2 - 2 h(r) of the radially symmetric convex potential h(r) = integral of sqrt(m),
/// where m(r) is the share of @p masses (n, > 0) at radii <= r. Its gradient spreads the radii of
/// @p sites (n x 2, unit disk) evenly by area over the disk of radius @p reach. Every site keeps a cell
/// because h is convex (docs/mathematics.md, "Optimal transport").
PowerDiagram::Weights radialPotentialWeights(const Points2& sites,
  const Eigen::VectorXd& masses,
  double reach = 1.0);

/// The greatest |log(target / area)| of all cells; infinite if a cell is empty.
double largestLogRatio(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets);

/// The weights whose cells are nearest to @p targets (n) by largestLogRatio(), among
/// - @p given (n, or empty), which are taken at once if no cell is off by more than a decade,
/// - 0, as in the paper, and radialPotentialWeights(),
/// - the sums of these two with the potential that opens dense clusters: groups of neighbouring cells
///   that have a thousandth of their target areas and less without weights. Protrusions of the surface
///   make them, and smaller protrusions upon these clusters within clusters, since the conformal map
///   shrinks exponentially along a protrusion. A convex potential that is radially symmetric about the
///   smallest cell opens each cluster to a disk and moves the other sites out of the way. Without
///   these sums, the transport of surfaces with protrusions takes 15 to 27 Newton steps instead of at
///   most 12 (TestTransport).
///
/// All but the given ones are gradients of convex functions, so that every site has a cell in the plane.
/// @p diagram  is updated with the result
/// @throws ConvergenceError if all starts leave a cell empty, Cancelled.
PowerDiagram::Weights initialWeights(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  const Eigen::VectorXd& given,
  const ProgressCallback& progress);

} // namespace flattening
