// SPDX-License-Identifier: GPL-3.0-or-later
/// Untangles a patch of a flat map by minimising an energy over its inner vertices.
#pragma once

#include "Base/Progress.h"
#include "Untangling/FoldoverEnergy.h"

#include <vector>

namespace flattening
{

/// The name of the stage that untangling reports with its progress.
constexpr const char* UntanglingStage = "Untangling of flipped faces";

/// Some faces of a flat map, with their own numbering. The first FreeVertices vertices may move.
struct FlatPatch
{
  Points2 Positions; ///< in units of about the patch's size
  int FreeVertices = 0;
  FaceMatrix Faces;                    ///< each with at least one free vertex
  std::vector<TargetTriangle> Targets; ///< one per face, in the same units
};

struct UntangledPatch
{
  bool Positive = false; ///< whether no face is flipped, to rounding; if not, discard the positions
  int Steps = 0;         ///< number of Newton steps
};

/// Moves the free vertices of @p patch to a minimum of the sum of the faces' energies
/// (FoldoverEnergy, with equal weights), by Newton's method with positive semidefinite Hessians.
/// While faces are flipped, the epsilon of the energies is reduced after every step (Garanzha et al.,
/// section 3.2). If it falls below a hundredth of the magnitude of the area ratio
/// (FoldoverEnergy::areaRatio) of the most flipped face, untangling is given up as hopeless. Once no
/// face is flipped, epsilon is 0, so that none flips again.
/// @param areaWeight  as in FoldoverEnergy, >= 0
/// @param progress  is told the share of the most steps at every step
/// @throws Cancelled; the positions are of no use then.
UntangledPatch untanglePatch(FlatPatch& patch, double areaWeight, const ProgressCallback& progress = {});

/// Moves the free vertices of @p patch to the means of their neighbours with equal weights (Tutte 1963).
/// If the rim is convex, this gives a start without flipped faces, however distorted.
/// @throws ConvergenceError if a free vertex is not connected to the rim; Cancelled.
void relaxPatch(FlatPatch& patch, const ProgressCallback& progress = {});

} // namespace flattening
