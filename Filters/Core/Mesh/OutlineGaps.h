// SPDX-License-Identifier: GPL-3.0-or-later
/// The empty plane between parts of the outline of a flat map, as triangles.
#pragma once

#include "Mesh/OutlineCrossings.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The triangles (k x 3, counter-clockwise) between a simple polygon and its convex hull: those of the
/// constrained Delaunay triangulation of its vertices that lie outside it (CGAL). As long as they and
/// the faces of the map stay counter-clockwise, parts of the outline that face each other cannot meet.
/// @p edges  the edges of the polygon, of which none may cross, at @p positions (n x 2, finite)
FaceMatrix outlineGaps(const Points2& positions, const std::vector<FlatEdge>& edges);

} // namespace flattening
