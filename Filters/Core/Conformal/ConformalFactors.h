// SPDX-License-Identifier: GPL-3.0-or-later
/// The scale of a flat map at its vertices.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// Natural logarithm, for every vertex (n), of the sum of its edges' lengths in @p positions over the
/// sum of their lengths on the surface, @p addedLength longer than they are. Of a smooth conformal map
/// it is the scale at the vertex up to the square of the edge length; on the boundary, where the edges
/// lie to one side, up to the edge length. Flat sums below 1e-16, which positions in the unit disk do
/// not resolve, count as that.
Eigen::VectorXd logConformalFactors(const TriangleMesh& mesh,
  const Points2& positions,
  double addedLength);

} // namespace flattening
