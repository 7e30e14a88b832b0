// SPDX-License-Identifier: GPL-3.0-or-later
/// Where to open a closed surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The vertex from which the rest of a connected surface is nearest, in the mean square: the centre of
/// the average geodesic distance (Zhang, Mischaikow, Turk 2005), here squared, taken along edges and
/// over a few points spread over the surface. A hole there lies neither on the tip of a protrusion nor
/// deep in a fold, so that the conformal map stretches the far side least. Equal candidates: the
/// smallest index.
/// @param avoided one flag per vertex, 0 where the centre may be; none: anywhere. The vertices farther
/// than @p clearance (along edges, input units) from every flagged one are candidates; if there are
/// none, the vertex farthest from them is the centre.
/// @throws InvalidInput if the flags are of another number than the vertices or all are set.
int geodesicCentre(const TriangleMesh& mesh,
  const std::vector<char>& avoided = {},
  double clearance = 0.0,
  const ProgressCallback& progress = {});

} // namespace flattening
