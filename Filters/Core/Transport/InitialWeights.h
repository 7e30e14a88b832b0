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
/// - @p given (n, or empty), which are returned at once if the area of every cell is within a factor
///   of about ten of its target,
/// - 0, as in the paper, and radialPotentialWeights(),
/// - the sums of each of these two with the weights of a potential that opens dense clusters.
///
/// A dense cluster is a group of neighbouring cells that, with weights 0, have at most a thousandth
/// of their target areas. A protrusion of the surface makes such a cluster, because the conformal map
/// shrinks exponentially along it; a smaller protrusion upon the first makes a cluster within the
/// cluster. The potential is convex and radially symmetric about the smallest cell of the cluster. It
/// opens the cluster to a disk and moves the other sites out of the way. Without these sums, the
/// transport of surfaces with protrusions takes 15 to 27 Newton steps instead of at most 12
/// (TestTransport).
///
/// All these weights except @p given belong to convex potentials, so that every site has a cell in
/// the plane.
/// @p diagram  is updated with the result
/// @throws ConvergenceError if all starts leave a cell empty, Cancelled.
PowerDiagram::Weights initialWeights(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  const Eigen::VectorXd& given,
  const ProgressCallback& progress);

} // namespace flattening
