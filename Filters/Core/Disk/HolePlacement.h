// SPDX-License-Identifier: GPL-3.0-or-later
/// The choice of the place where a hole opens a closed surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The vertex with the least mean squared distance from the rest of a connected surface: the centre of
/// the average geodesic distance (Zhang, Mischaikow, Turk 2005, "Feature-based surface parameterization
/// and texture mapping"), here squared, and measured along edges from a few points spread over the
/// surface. A hole there lies neither on the tip of a protrusion nor deep in a fold, so that the
/// conformal map stretches the far side least. Of equal candidates the one with the smallest index is
/// taken.
/// @param avoided one flag per vertex, 0 where the centre may be; empty: it may be anywhere. Candidates
/// are the vertices farther than @p clearance (along edges, input units) from every flagged one; if
/// there is none, the vertex farthest from the flagged ones is the centre.
/// @throws InvalidInput if the flags are of another number than the vertices or all are set.
int geodesicCentre(const TriangleMesh& mesh,
  const std::vector<char>& avoided = {},
  double clearance = 0.0,
  const ProgressCallback& progress = {});

} // namespace flattening
