// SPDX-License-Identifier: GPL-3.0-or-later
/// The scale of a flat map at its vertices.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// For every vertex (n), the natural logarithm of a ratio of lengths: the root mean square length in
/// @p positions (n x 2) of the sides of the faces around the vertex, over the root mean square length
/// of the same sides on @p surface. For a smooth conformal map the result is the logarithm of its
/// scale at the vertex, with an error of the order of the squared edge length or, on the boundary, of
/// the edge length. Lengths below the resolution of doubles count as 1e-15, so that the result is
/// finite.
Eigen::VectorXd logConformalFactors(const TriangleMesh& surface, const Points2& positions);

} // namespace flattening
