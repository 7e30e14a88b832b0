// SPDX-License-Identifier: GPL-3.0-or-later
/// Which points of a surface coincide.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// For every point the index of its representative (n): the first point with the same coordinates,
/// itself if there is no other one. With @p tolerance > 0 (input units) the representatives are then
/// visited in the order of their indices, and those within the tolerance of one that is left join it. A
/// point that is not finite is its own representative.
std::vector<int> coincidentPoints(const Points3& points, double tolerance = 0.0);

} // namespace flattening
