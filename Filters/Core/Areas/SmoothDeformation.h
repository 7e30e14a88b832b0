// SPDX-License-Identifier: GPL-3.0-or-later
/// A smooth deformation of the plane that lowers the distortion of the shapes of a flat map.
#pragma once

#include "Areas/DeformationEnergy.h"
#include "Areas/DegreesOfFreedom.h"
#include "Areas/RefinementTerms.h"
#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{

/// The map @p positions (n x 2) after the deformation that minimises DeformationEnergy, found by
/// Newton's method. All faces of @p terms are positive before. Afterwards the thinnest of them may be
/// flipped, where the deformation bends their sides, and areas are a little off.
/// @p targets (m, > 0) are the areas that the faces should have, and @p areaWeight (> 0) is their weight
/// against shapes.
/// @throws Cancelled.
Points2 smoothlyDeformed(const RefinementTerms& terms,
  const Points2& positions,
  const Eigen::VectorXd& targets,
  double areaWeight,
  const ProgressCallback& progress = {});

/// The same for a map to a convex domain: the boundary vertices slide along its boundary, and those that
/// stay (@p dofs) do so. Faces of @p map may be flipped; these count for nothing. @p shapes are those
/// that faces should have.
DomainMap smoothlyDeformed(const RefinementTerms& terms,
  const DegreesOfFreedom& dofs,
  const DomainMap& map,
  const Eigen::VectorXd& targets,
  DeformationEnergy::Shapes shapes,
  double areaWeight,
  const ProgressCallback& progress = {});

} // namespace flattening
