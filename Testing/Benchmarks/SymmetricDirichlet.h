// SPDX-License-Identifier: GPL-3.0-or-later
/// Minimisation of the symmetric Dirichlet energy with a free outline, a baseline for maps whose outline
/// is not given.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening::benchmarks
{

/// The map that makes the symmetric Dirichlet energy least, by scalable locally injective mappings
/// (Rabinovich, Poranne, Panozzo, Sorkine-Hornung 2017): every step minimises a quadratic energy whose
/// gradient is that of the true one. It begins with Tutte's map to a disk of the surface's area. A step
/// ends before a face flips (Smith and Schaefer 2015, "Bijective Parameterization with Free Boundaries",
/// section 3) and before a vertex of the outline meets an edge of it, so that the map stays bijective.
/// @throws InvalidInput, TopologyError (see requireDisk), ConvergenceError if a matrix cannot be
/// factored.
Points2 symmetricDirichletMap(const TriangleMesh& mesh, int iterations);

/// The number of pairs of edges of the closed polygon through the vertices of @p loop that cross or
/// touch without being neighbours (exact).
int outlineCrossings(const Points2& positions, const std::vector<int>& loop);

} // namespace flattening::benchmarks
