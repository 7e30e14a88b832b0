// SPDX-License-Identifier: GPL-3.0-or-later
/// The mean curvature of a triangle mesh as a measure: robust against slivers, as nothing is divided by
/// the area of one of them.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{

/// Of each vertex (n) the integral of the mean curvature over its part of the surface (input units): a
/// quarter of length times signed angle of every edge around it (Cohen-Steiner and Morvan 2003,
/// "Restricted Delaunay triangulations and normal cycle"). Positive where a surface whose normals point
/// outward is convex. Divided by a third of the area around the vertex it is its mean curvature (one
/// over input units). Edges that have not two faces of the same orientation, those of a boundary for
/// instance, count nothing.
/// @throws InvalidInput if a coordinate is not finite.
Eigen::VectorXd integratedMeanCurvature(const TriangleMesh& mesh);

} // namespace flattening
