// SPDX-License-Identifier: GPL-3.0-or-later
/// Well-shaped triangles along a boundary that a cut has just made.
#pragma once

#include "EditableSurface.h"

namespace flattening
{

/// Removes the slivers that a curve leaves where it passes close to vertices.
/// Short edges at the boundary are collapsed, shortest first: boundary vertices too close to each other
/// become one of them, inner vertices too close to the boundary move onto it. Short is below 0.8 of the
/// mean boundary edge. A collapse must keep the topology, tilt no face by more than 60 degrees, and
/// leave angles of 20 degrees or no smaller ones than before. Then edges beside the boundary are flipped
/// where the surface is flat (11 degrees) and that makes the smallest angle larger; both in turns until
/// nothing changes. At least @p minimumVertices boundary vertices are left, if there are as many.
void conditionBoundary(EditableSurface& surface, int minimumVertices);

} // namespace flattening
