// SPDX-License-Identifier: GPL-3.0-or-later
/// Meshes with slivers on smooth surfaces.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <cstdint>

namespace flattening::samples
{

/// Splits random faces of @p mesh, @p splits times, each in three at a point close to one of its sides
/// or corners, as long as no angle becomes smaller than @p leastAngle (degrees). The surface keeps its
/// shape. The same seed gives the same mesh on every platform.
TriangleMesh withRandomSlivers(const TriangleMesh& mesh,
  int splits,
  double leastAngle,
  std::uint64_t seed);

/// The smallest angle of any face of @p mesh, degrees.
double smallestAngleOf(const TriangleMesh& mesh);

} // namespace flattening::samples
