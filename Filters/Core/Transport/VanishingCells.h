// SPDX-License-Identifier: GPL-3.0-or-later
/// Vanishing cells: the few cells that would make the step of all others short.
#pragma once

#include "Base/Progress.h"
#include "Transport/PowerDiagram.h"

namespace flattening
{

/// The number of cells, for a diagram of @p sites cells, that may vanish in a step: that have less
/// than their least area after it. If more cells vanish, the step is too long.
int largestVanishing(int sites);

/// Raises the weights of the vanishing cells, whose areas are below @p least (n, > 0), and of these
/// alone, until no area is below @p least. Along the circle and in protrusions, a cell may be much
/// thinner than the distance by which a good step moves its sides. A step that leaves none of these
/// cells empty would have to be very short. To enlarge a few small cells instead takes little area
/// from their neighbours.
///
/// A hidden site first gets the weight that it lacks for a cell. Then the weight of every vanishing
/// cell is raised: at first by as much as would gain ten times @p least at the rate @p slopes
/// (ownSlopes() before the step), and in each further round by four times as much as in the last.
/// @param diagram  updated with @p weights, with at most largestVanishing() hidden sites; afterwards
/// updated with the raised weights
/// @param weights  n, raised in place
/// @param progress  reports before every further diagram
/// @returns false if too many cells vanish, or if some still do after the last round.
/// @throws Cancelled.
bool feedVanishingCells(PowerDiagram& diagram,
  PowerDiagram::Weights& weights,
  const Eigen::VectorXd& least,
  const Eigen::VectorXd& slopes,
  const ProgressCallback& progress);

/// The derivative of every cell's area by the weight of its site (n): half the sum over the sides of
/// the cell of the length of the side divided by the distance of the two sites beside it.
Eigen::VectorXd ownSlopes(const PowerDiagram& diagram);

} // namespace flattening
