// SPDX-License-Identifier: GPL-3.0-or-later
/// How much a flat map distorts shapes.
#pragma once

#include "Areas/RefinementTerms.h"
#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// The mean over the area of the logarithm of the ratio of Dirichlet energy to area, for the faces of
/// @p terms at @p positions (n x 2), weighted by @p targets (m, > 0); 0 if all shapes are kept. Flipped
/// faces count as undistorted.
double shapeDistortion(const RefinementTerms& terms,
  const Points2& positions,
  const Eigen::VectorXd& targets);

} // namespace flattening
