// SPDX-License-Identifier: GPL-3.0-or-later
/// Local changes that take the faces of a resampled surface out of each other.
#pragma once

#include "Base/Progress.h"
#include "Remeshing/MeshOnSurface.h"

namespace flattening
{

/// Where faces intersect, flips their edges and moves their vertices, at most by 0.4 of the length of an
/// edge and off the old surface, until none does or nothing helps: every change makes the pairs fewer
/// and no angle smaller than 10 degrees, unless it was. Then smooths the surface around those that are
/// left (smoothIntersections). Returns the number of pairs left.
int removeSelfIntersections(MeshOnSurface& surface, const ProgressCallback& progress = {});

} // namespace flattening
