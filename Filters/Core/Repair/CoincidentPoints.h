// SPDX-License-Identifier: GPL-3.0-or-later
/// Which points of a surface are the same point.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// For every point the smallest index among the points that it coincides with (its own if none): n.
/// With @p tolerance > 0 (input units), points within that distance of a representative join it, taken
/// in the order of their indices.
std::vector<int> coincidentPoints(const Points3& points, double tolerance = 0.0);

} // namespace flattening
