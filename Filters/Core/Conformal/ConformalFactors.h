// SPDX-License-Identifier: GPL-3.0-or-later
/// The scale of a flat map at its vertices.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// The natural logarithm, for every vertex (n), of the total length of its edges in @p positions (n x 2)
/// over their total length on the surface, with @p addedLength added to each edge. For a smooth
/// conformal map this is the logarithm of its scale at the vertex, with an error of the order of the
/// squared edge length, or of the edge length on the boundary. A flat total below 1e-16 counts as 1e-16.
Eigen::VectorXd logConformalFactors(const TriangleMesh& mesh,
  const Points2& positions,
  double addedLength);

} // namespace flattening
