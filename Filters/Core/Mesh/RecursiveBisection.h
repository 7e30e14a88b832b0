// SPDX-License-Identifier: GPL-3.0-or-later
/// Compact parts of a set of points in the plane.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Halves the points, and the halves, by lines across the longer side of the box around them until no
/// part has more than @p largest points. The lines are parallel to two axes at right angles, of which
/// the first has the angle @p angle (radians). Returns the indices of the points of every part in
/// ascending order.
std::vector<std::vector<int>> recursiveBisection(const Points2& points, int largest, double angle);

} // namespace flattening
