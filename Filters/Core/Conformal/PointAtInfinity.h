// SPDX-License-Identifier: GPL-3.0-or-later
/// The choice of the boundary vertex that goes to infinity when a disk is mapped to the half-plane.
#pragma once

#include "Intrinsic/IntrinsicTriangulation.h"

#include <vector>

namespace flattening
{

/// The boundary vertices that can be sent to infinity, best first. The neighbours of such a vertex are
/// distinct and, but for the first and the last, interior vertices. The best vertex has a star of wide
/// angles on a straight piece of the boundary, and the circumcircles of the star's faces keep clear of
/// the vertices beyond it.
std::vector<int> verticesForInfinity(const IntrinsicTriangulation& triangulation);

} // namespace flattening
