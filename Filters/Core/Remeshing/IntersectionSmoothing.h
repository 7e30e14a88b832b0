// SPDX-License-Identifier: GPL-3.0-or-later
/// Smooths a mesh where faces intersect and no change of a few of them helps.
#pragma once

#include "Remeshing/IntersectionQueries.h"

namespace flattening
{

/// Moves the vertices at most 1, then 2, 3 and 4 edges away from each pair of intersecting faces to the
/// means of their neighbours, several times over, which draws in a fold that passes through another. A
/// move is kept only if fewer faces intersect afterwards and no angle is smaller than 5 degrees or, in a
/// second attempt, 1 degree, unless it was before. Returns the pairs that are left.
/// Reports for each pair.
FacePairs smoothIntersections(MeshOnSurface& surface,
  FacePairs pairs,
  const ProgressCallback& progress = {});

} // namespace flattening
