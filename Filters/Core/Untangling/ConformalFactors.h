// SPDX-License-Identifier: GPL-3.0-or-later
/// The scale of a flat map at its vertices.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// The natural logarithm, for every vertex (n), of the root mean square length in @p positions (n x 2)
/// of the sides of the faces around it, over the same on @p surface. For a smooth conformal map this is
/// the logarithm of its scale at the vertex, with an error of the order of the squared edge length, or
/// of the edge length on the boundary. Lengths below the resolution of doubles count as 1e-15, so that
/// the result is finite.
Eigen::VectorXd logConformalFactors(const TriangleMesh& surface, const Points2& positions);

} // namespace flattening
