// SPDX-License-Identifier: GPL-3.0-or-later
/// The mean curvature of a triangle mesh as a measure, which is robust against slivers, as it does not
/// divide by the area of a face.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{

/// The integral of the mean curvature over the part of the surface around each vertex (n, input units):
/// a quarter of the length times the signed angle of every edge at the vertex (Cohen-Steiner and Morvan
/// 2003, "Restricted Delaunay triangulations and normal cycle"). It is positive where a surface with
/// outward normals is convex. Divided by a third of the area around the vertex, it gives the mean
/// curvature (one over input units). Edges without two consistently oriented faces, such as boundary
/// edges, contribute nothing.
/// @throws InvalidInput if a coordinate is not finite.
Eigen::VectorXd integratedMeanCurvature(const TriangleMesh& mesh);

} // namespace flattening
