// SPDX-License-Identifier: GPL-3.0-or-later
/// Boundary First Flattening with its natural outline, a baseline for maps with a free outline.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening::benchmarks
{

/// The conformal map whose boundary keeps its lengths, which of all conformal maps has the least area
/// distortion (Sawhney and Crane 2017, "Boundary First Flattening", sections 4 and 5): factors that are
/// 0 on the boundary give the curvature of the outline, which is integrated and closed by the smallest
/// change of lengths; inside, both coordinates are harmonic. The outline may cross itself and faces may
/// flip.
/// @throws InvalidInput, TopologyError (see requireDisk), ConvergenceError if a matrix cannot be
/// factored.
Points2 naturalBoundaryMap(const TriangleMesh& mesh);

} // namespace flattening::benchmarks
