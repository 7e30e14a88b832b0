// SPDX-License-Identifier: GPL-3.0-or-later
/// Where the transport may start: power weights that leave no cell empty.
#pragma once

#include "Transport/PowerDiagram.h"

namespace flattening
{

/// Weights w = r^2 - 2 h(r) of the radially symmetric convex potential h(r) = integral of sqrt(m), m(r)
/// the share of @p masses (n) at radius <= r: its gradient spreads the radii of @p sites (n x 2, unit
/// disk) evenly by area over the disk of radius @p reach. Every site keeps a cell, since h is convex;
/// only the transport's Newton iteration starts from it, its result stays the Brenier map
/// (mathematics.md, "Peers").
PowerDiagram::Weights radialPotentialWeights(const Points2& sites,
  const Eigen::VectorXd& masses,
  double reach = 1.0);

/// |y|^2 of every site (n).
PowerDiagram::Weights squaredRadii(const Points2& sites);

} // namespace flattening
