// SPDX-License-Identifier: GPL-3.0-or-later
/// Which boundary vertex goes to infinity when a disk is mapped to the half-plane.
#pragma once

#include "Intrinsic/IntrinsicTriangulation.h"

#include <vector>

namespace flattening
{

/// 1 for every vertex on the boundary, else 0.
std::vector<char> boundaryVertices(const IntrinsicTriangulation& triangulation);

/// The boundary vertices that can be sent to infinity, best first: those whose neighbours are distinct
/// and inside of the surface but for the first and the last. Best is a star of wide angles, on a
/// straight piece of the boundary, whose circumcircles keep clear of the vertices behind its link.
std::vector<int> verticesForInfinity(const IntrinsicTriangulation& triangulation);

} // namespace flattening
