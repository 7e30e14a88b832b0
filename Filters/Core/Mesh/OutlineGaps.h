// SPDX-License-Identifier: GPL-3.0-or-later
/// The empty plane between parts of the outline of a flat map, as triangles.
#pragma once

#include "Mesh/OutlineCrossings.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The triangles (k x 3, counter-clockwise) between a simple polygon and its convex hull: those of the
/// constrained Delaunay triangulation of its vertices that lie outside it (OutlineTriangulation). As
/// long as they and the faces of the map stay counter-clockwise, parts of the outline that face each
/// other cannot meet.
/// @p edges  the edges of the polygon, of which none may cross, at @p positions (n x 2, finite)
FaceMatrix outlineGaps(const Points2& positions, const std::vector<FlatEdge>& edges);

/// Leaves out those of the @p gaps that fill shallow bays, and returns the others. A bay is shallow if a
/// single triangle fills it whose angle is above 120 degrees, or if one does after shallow bays on its
/// sides are filled. Such a triangle keeps no parts of the outline apart, but would resist if the bay
/// were to become convex.
/// @p edges  the edges of the polygon, in order, with its inside on the left
FaceMatrix withoutShallowBays(const FaceMatrix& gaps,
  const Points2& positions,
  const std::vector<FlatEdge>& edges);

} // namespace flattening
