// SPDX-License-Identifier: GPL-3.0-or-later
/// Vanishing cells: the few cells that would make the step of all others short.
#pragma once

#include "Base/Progress.h"
#include "Transport/PowerDiagram.h"

namespace flattening
{

/// How many of @p sites cells may vanish in a step; with more, the step is too long.
int largestVanishing(int sites);

/// Raises the weights of the cells whose area is below @p least (n, > 0), and of these alone, until no
/// cell is. Along the circle and in protrusions, cells may be much thinner than a good step moves their
/// sides, and a step that leaves none of them empty would have to be very short; a few small cells take
/// little from their neighbours. Hidden sites first get the weight that they lack for a cell. Then every
/// vanishing cell gets a raise that would gain ten times @p least by @p slopes (ownSlopes() before the
/// step), and in each further round four times as much.
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

/// The derivative of every cell's area by its own weight (n): half the sum of its sides' lengths over
/// the distances of their sites.
Eigen::VectorXd ownSlopes(const PowerDiagram& diagram);

} // namespace flattening
