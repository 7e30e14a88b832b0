// SPDX-License-Identifier: GPL-3.0-or-later
/// Smooths a resampled surface where faces intersect and no change of a few of them helps.
#pragma once

#include "Remeshing/IntersectionQueries.h"

namespace flattening
{

/// Around every pair the vertices up to 1, 2, 3 and 4 edges away go to the means of their neighbours,
/// again and again, which draws in a fold that passes through another. That is done only where it makes
/// the pairs fewer and no angle smaller than 5 degrees or, if nothing else helps, 1 degree, unless it
/// was. Returns the pairs that are left.
FacePairs smoothIntersections(MeshOnSurface& surface, FacePairs pairs);

} // namespace flattening
