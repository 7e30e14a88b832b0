// SPDX-License-Identifier: GPL-3.0-or-later
/// Where the vertices of a boundary loop lie on the unit circle.
#pragma once

#include "Conformal/DiskNormalisation.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Lengths of the edges from each vertex of @p loop to the next (input units), @p addedLength longer
/// than they are.
Eigen::VectorXd loopLengths(const TriangleMesh& mesh, const std::vector<int>& loop, double addedLength);

/// Angles of the vertices of a loop (radians), from 0 for the first on counter-clockwise to below 2 pi,
/// whose differences are in proportion to @p lengths, those of the edges that follow them.
Eigen::VectorXd anglesInProportion(const Eigen::VectorXd& lengths);

/// The points of the half-plane's boundary that the Cayley map with centre i takes to @p angles on the
/// circle: infinity for angle 0.
ComplexVector halfPlaneBoundary(const Eigen::VectorXd& angles);

} // namespace flattening
