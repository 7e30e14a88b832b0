// SPDX-License-Identifier: GPL-3.0-or-later
/// Lengths and angles of a triangle mesh in space.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The length of the closed polyline through the vertices of @p loop, input units.
double loopLength(const Points3& vertices, const std::vector<int>& loop);

/// The mean length of the faces' sides, input units; an edge between two faces counts twice.
double meanEdgeLength(const TriangleMesh& mesh);

/// The smallest angle of all faces, degrees in [0, 60]; 0 if a face has no area, 180 if there is no
/// face.
double smallestAngle(const TriangleMesh& mesh);

} // namespace flattening
