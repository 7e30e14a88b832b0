// SPDX-License-Identifier: GPL-3.0-or-later
/// Positions of a boundary loop's vertices on the unit circle.
#pragma once

#include "Mesh/ComplexPositions.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Lengths of the edges from each vertex of @p loop to the next (input units), each increased by @p
/// addedLength (see IntrinsicTriangulation::addedLength).
Eigen::VectorXd loopLengths(const TriangleMesh& mesh, const std::vector<int>& loop, double addedLength);

/// Angles of a loop's vertices (radians, in [0, 2 pi), ascending from 0 for the first vertex) whose
/// differences are proportional to @p lengths, the lengths of the edges that follow the vertices.
Eigen::VectorXd anglesInProportion(const Eigen::VectorXd& lengths);

/// The points of the real axis that the Cayley map with centre i takes to @p angles on the unit circle
/// (radians, in [0, 2 pi)); infinity for angle 0.
ComplexVector halfPlaneBoundary(const Eigen::VectorXd& angles);

} // namespace flattening
