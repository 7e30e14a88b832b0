// SPDX-License-Identifier: GPL-3.0-or-later
/// What areas vertices and faces of a map should have, by those of the surface and by weights.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// The area that each vertex is to have in a domain of area pi: a third of its incident faces' areas
/// times its weight, scaled to the sum pi (paper, section 4.1). @p weights (n) may be empty: all 1.
/// @throws InvalidInput if a weight is not a positive number, if weights leave a vertex less than 2e-16
/// of the domain, or if a vertex has no area.
Eigen::VectorXd targetAreas(const TriangleMesh& mesh, const Eigen::VectorXd& weights);

/// What a face's area should become, from the weights of its corners: its area times their mean (m).
/// @p weights (n) may be empty: all 1.
Eigen::VectorXd faceTargets(const TriangleMesh& mesh, const Eigen::VectorXd& weights);

} // namespace flattening
