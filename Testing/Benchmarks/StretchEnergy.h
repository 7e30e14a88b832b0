// SPDX-License-Identifier: GPL-3.0-or-later
/// Stretch-energy minimisation, a baseline for area-preserving maps.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening::benchmarks
{

/// The map to the unit disk of Yueh, Lin, Wu, Yau, "A novel stretch energy minimization algorithm for
/// equiareal parameterizations", J. Sci. Comput. 78 (2019): the boundary on the circle in proportion to
/// its length; inside, the harmonic map, and then @p iterations solves of Laplace's equation, each with
/// the cotangents of the flat faces before it, a face's times its flat over its surface area.
/// Faces may flip.
/// @throws InvalidInput, TopologyError (see requireDisk), InvalidInput if a face has no area,
/// ConvergenceError if a matrix cannot be factored.
Points2 stretchEnergyDiskMap(const TriangleMesh& mesh, int iterations);

} // namespace flattening::benchmarks
