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

/// The map @p map after the deformation that minimises DeformationEnergy, found by Newton's method.
/// Faces may be flipped before; these count for nothing. Afterwards the thinnest faces may be flipped,
/// where the deformation bends their sides, and areas are a little off. In a map to a domain, the
/// boundary vertices slide along its boundary, and those that stay (@p dofs) do so.
/// @p targets (m, > 0) are the areas that the faces should have, @p shapes their shapes, and @p
/// areaWeight (> 0) is the weight of areas against shapes.
/// @throws Cancelled.
DomainMap smoothlyDeformed(const RefinementTerms& terms,
  const DegreesOfFreedom& dofs,
  const DomainMap& map,
  const Eigen::VectorXd& targets,
  DeformationEnergy::Shapes shapes,
  double areaWeight,
  const ProgressCallback& progress = {});

} // namespace flattening
