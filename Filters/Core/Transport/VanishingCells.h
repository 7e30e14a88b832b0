// SPDX-License-Identifier: GPL-3.0-or-later
/// The few cells that would hold every other one's step back.
#pragma once

#include "Base/Progress.h"
#include "Transport/PowerDiagram.h"

namespace flattening
{

/// How many of @p sites cells may be starved: of more, the step was too long.
int largestVanishing(int sites);

/// Along the circle, and in horns, cells may be much thinner than a good step moves their sides, and a
/// step that leaves none of them empty would have to be as short as the thinnest. Instead the weights of
/// the cells whose area is below @p least (n, > 0) are raised, and of these alone, until none is: a few
/// small cells take little from their neighbours. Hidden sites get what they lack for a cell, and all
/// then a raise. A first would gain ten times @p least at @p slopes (n, how fast areas grew with their
/// own weights before the step), each further one is four times as large.
/// @param diagram  just updated with @p weights, up to largestVanishing sites hidden; with the new ones
/// afterwards
/// @param weights  n, raised in place
/// @param progress  told nothing new before every further diagram
/// @returns whether no cell is below; false if that took too many cells or rounds, or did not get
/// better.
/// @throws Cancelled.
bool feedVanishingCells(PowerDiagram& diagram,
  PowerDiagram::Weights& weights,
  const Eigen::VectorXd& least,
  const Eigen::VectorXd& slopes,
  const ProgressCallback& progress);

/// How fast the area of every cell grows with its own weight (n): half the sum of its sides' lengths
/// over their sites' distances.
Eigen::VectorXd ownSlopes(const PowerDiagram& diagram);

} // namespace flattening
