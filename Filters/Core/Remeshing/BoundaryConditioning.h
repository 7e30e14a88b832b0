// SPDX-License-Identifier: GPL-3.0-or-later
/// Well-shaped triangles along a boundary that a cut has made.
#pragma once

#include "Mesh/EditableSurface.h"

#include <vector>

namespace flattening
{

/// Removes the slivers that a curve leaves where it passes close to vertices.
///
/// Edges at the boundary that are shorter than 0.8 of the mean boundary edge are collapsed, shortest
/// first: boundary vertices too close to each other become one of them, inner vertices too close to the
/// boundary move onto it. A collapse must keep the topology, tilt no face by more than 60 degrees, and
/// leave angles of 20 degrees or no smaller ones than before. Then edges beside the boundary are flipped
/// (flipWhileImproving). Both alternate until nothing changes. At least @p minimumVertices boundary
/// vertices are left, if there were as many.
void conditionBoundary(EditableSurface& surface, int minimumVertices);

/// The same, but only for boundary edges between vertices flagged in @p onCut (one flag per vertex).
/// Other boundaries stay as they are, and so do the ends of the cut on them. The cut keeps its curve: it
/// loses vertices, but none of them moves off the curve.
void conditionCut(EditableSurface& surface, const std::vector<char>& onCut, int minimumVertices);

} // namespace flattening
