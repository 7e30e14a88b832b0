// SPDX-License-Identifier: GPL-3.0-or-later
/// Meshes of slivers on surfaces that are smooth.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <cstdint>

namespace flattening::samples
{

/// @p mesh with @p splits random faces (of those there are by then) split in three at a point close to
/// one of their sides or corners, as long as no angle becomes smaller than @p leastAngle (degrees). The
/// surface stays as it is. The same seed gives the same mesh on every platform.
TriangleMesh withRandomSlivers(const TriangleMesh& mesh,
  int splits,
  double leastAngle,
  std::uint64_t seed);

/// The smallest angle of any face of @p mesh, degrees.
double smallestAngleOf(const TriangleMesh& mesh);

} // namespace flattening::samples
