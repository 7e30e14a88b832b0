// SPDX-License-Identifier: GPL-3.0-or-later
/// CGAL's iterative authalic parameterization, a baseline for area-preserving maps.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening::benchmarks
{

/// CGAL's Iterative_authalic_parameterizer_3 to the unit disk, with its defaults: the boundary on the
/// circle in proportion to its length, 15 iterations of which it keeps the best. It writes each
/// iteration's map to a file, which is in its time. Faces may flip.
/// @throws TopologyError (see requireDisk), ConvergenceError with CGAL's message.
Points2 iterativeAuthalicDiskMap(const TriangleMesh& mesh);

} // namespace flattening::benchmarks
