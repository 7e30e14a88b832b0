// SPDX-License-Identifier: GPL-3.0-or-later
/// Places of the conformal map where the mass of many sites lies as if in one point.
#pragma once

#include "Transport/PowerDiagram.h"

#include <vector>

namespace flattening
{

/// Sites that lie together in a place with far too little area.
struct DenseCluster
{
  std::vector<int> Sites; ///< by distance from the first, which has the least area for its mass
  double Mass = 0.0;
};

/// The clusters of sites of @p diagram whose cells have less than a thousandth of their target area in
/// @p targets (n), next to each other. Those with less than 1e-7, 1e-11 and so on within a cluster make
/// clusters of their own, without which it is counted. Horns of the surface, and horns upon these, make
/// them: there the conformal map shrinks exponentially.
std::vector<DenseCluster> denseClusters(const PowerDiagram& diagram, const Eigen::VectorXd& targets);

/// A sum of convex potentials, one per cluster, radially symmetric about its first site: h'(r) is the
/// radius of the disk with the mass of the cluster within r, where @p totalMass has radius 1. Its
/// gradient opens each cluster to a disk and moves the other sites out of the way. One value per site,
/// in extended precision, as the members of a cluster differ little.
PowerDiagram::Weights openingPotential(const PowerDiagram& diagram,
  const std::vector<DenseCluster>& clusters,
  const Eigen::VectorXd& targets,
  double totalMass);

} // namespace flattening
