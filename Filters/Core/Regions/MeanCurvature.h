// SPDX-License-Identifier: GPL-3.0-or-later
/// The mean curvature of a triangle mesh as a measure, which is robust against slivers, as it does not
/// divide by the area of a face.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{

/// The integral of the mean curvature over the part of the surface around each vertex (n, input units).
/// It is the sum over the edges at the vertex of a quarter of the length of the edge times its signed
/// angle, the angle between the normals of its two faces (Cohen-Steiner and Morvan 2003, "Restricted
/// Delaunay triangulations and normal cycle"). The angle is positive at a convex edge of a surface with
/// outward normals. Divided by a third of the area around the vertex, the integral gives the mean
/// curvature (one over input units). Edges without two consistently oriented faces, such as boundary
/// edges, contribute nothing.
/// @throws InvalidInput if a coordinate is not finite.
Eigen::VectorXd integratedMeanCurvature(const TriangleMesh& mesh);

} // namespace flattening
