// SPDX-License-Identifier: GPL-3.0-or-later
/// Parts of a set of points in the plane.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Halves the points by a line across the longer way through them until no part has more than
/// @p largest; @p angle (radians) is that of the first axis of the lines. Returns the points of every
/// part, in ascending order. The same points give the same parts.
std::vector<std::vector<int>> recursiveBisection(const Points2& points, int largest, double angle);

} // namespace flattening
