// SPDX-License-Identifier: GPL-3.0-or-later
/// The mean curvature as a picture of the surface: folds and features that can be recognised on a map.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{

/// The mean curvature of a surface of any size and place, averaged over a small ball around every vertex
/// and scaled (n, dimensionless): nine tenths of the area have values from -1 to 1. It is positive on
/// ridges of a surface with outward normals and negative in furrows. All are 0 on a surface that is flat
/// up to rounding.
Eigen::VectorXd scaledCurvature(const TriangleMesh& mesh, const ProgressCallback& progress = {});

} // namespace flattening
