// SPDX-License-Identifier: GPL-3.0-or-later
/// Where to open a closed surface.
#pragma once

#include "Progress.h"
#include "TriangleMesh.h"

namespace flattening
{

/// The vertex from which the rest of a connected surface is nearest, in the mean square: the centre of
/// the average geodesic distance (Zhang, Mischaikow, Turk 2005), here squared, taken along edges and
/// over a few points spread over the surface. A hole there lies neither on the tip of a protrusion nor
/// deep in a fold, so that the conformal map stretches the far side least. Equal candidates: the
/// smallest index.
int geodesicCentre(const TriangleMesh& mesh, const ProgressCallback& progress = {});

} // namespace flattening
