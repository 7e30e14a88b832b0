// SPDX-License-Identifier: GPL-3.0-or-later
/// Cleans the triangles along a boundary that a cut has just made.
#pragma once

#include "EditableSurface.h"

namespace flattening
{

/// Collapses the short edges at the boundary of @p surface, shortest first: boundary vertices too close
/// to each other become one of them, inner vertices too close to the boundary move onto it. Short is
/// below half of the mean boundary edge. An edge stays if its collapse would change the topology, tilt a
/// face by more than 60 degrees, lower the smallest angle around it, or leave fewer than @p
/// minimumVertices boundary vertices.
void collapseShortEdgesAtBoundary(EditableSurface& surface, int minimumVertices);

} // namespace flattening
