// SPDX-License-Identifier: GPL-3.0-or-later
/// Stretch-energy minimisation, a baseline for area-preserving maps.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening::benchmarks
{

struct StretchEnergyMap
{
  Points2 Positions;
  /// The energy after each iteration, with the weights of the map before it. The least that there is, if
  /// every face keeps its area, is the square of the map's area, nearly pi, over that of the surface.
  std::vector<double> Energies;
};

/// The map to the unit disk of Yueh, Lin, Wu, Yau, "A novel stretch energy minimization algorithm for
/// equiareal parameterizations", J. Sci. Comput. 78 (2019). It begins with the harmonic map whose
/// boundary lies on the circle in proportion to its length. Each of at most @p iterations weights an
/// edge with the cotangents of the flat faces beside it, a face's times its flat over its surface area,
/// and solves Laplace's equation twice: for the boundary, with the inner vertices reflected at the
/// circle, and inside. It ends before the energy grows. Faces may flip.
/// @throws InvalidInput, TopologyError (see requireDisk), InvalidInput if a face has no area,
/// ConvergenceError if a matrix cannot be factored.
StretchEnergyMap stretchEnergyDiskMap(const TriangleMesh& mesh, int iterations);

} // namespace flattening::benchmarks
