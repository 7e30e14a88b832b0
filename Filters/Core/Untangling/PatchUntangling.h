// SPDX-License-Identifier: GPL-3.0-or-later
/// Moves the inner vertices of a patch of a flat mesh until no face is flipped.
#pragma once

#include "Untangling/FoldoverEnergy.h"

#include <vector>

namespace flattening
{

/// A few faces of a flat mesh, with numbers of their own. The first FreeVertices vertices may move.
struct FlatPatch
{
  Points2 Positions; ///< in units of about the patch's size
  int FreeVertices = 0;
  FaceMatrix Faces;                    ///< each with a free vertex
  std::vector<TargetTriangle> Targets; ///< per face, in the same units
};

struct UntangledPatch
{
  bool Positive = false; ///< whether, to rounding, no face is flipped; if not, Positions are of no use
  int Steps = 0;         ///< of Newton's method
};

/// Moves the free vertices of @p patch to a minimum of the sum of the faces' energies (FoldoverEnergy,
/// every face of the same weight), by Newton's method with convex Hessians. While faces are flipped,
/// epsilon goes to 0 with the area of the most flipped one (Garanzha et al., section 3.2), until that is
/// hopeless; once none is, none becomes so again.
UntangledPatch untanglePatch(FlatPatch& patch, double areaWeight);

/// Moves the free vertices of @p patch to the equilibrium of equal springs along its edges: a start
/// without flipped faces, however bad, for a patch with a convex rim (Tutte 1963).
/// @throws ConvergenceError if a free vertex does not hang on the rim.
void relaxPatch(FlatPatch& patch);

} // namespace flattening
