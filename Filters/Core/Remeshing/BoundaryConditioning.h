// SPDX-License-Identifier: GPL-3.0-or-later
/// Well-shaped triangles along a boundary that a cut has just made.
#pragma once

#include "Mesh/EditableSurface.h"

#include <vector>

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

/// The same for boundary edges between vertices marked in @p onCut (one flag per vertex) alone. Other
/// boundaries stay as they are, the ends of the cut at them too, and the cut keeps its curve: its
/// vertices become fewer, but none moves off it.
void conditionCut(EditableSurface& surface, const std::vector<char>& onCut, int minimumVertices);

} // namespace flattening
