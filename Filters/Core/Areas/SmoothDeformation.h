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
/// areaWeight (> 0) is the weight of areas against shapes. The lattice around a map whose boundary
/// is free is @p fineness (>= 1) times as fine as usual (latticeSquares).
/// @throws Cancelled.
DomainMap smoothlyDeformed(const RefinementTerms& terms,
  const DegreesOfFreedom& dofs,
  const DomainMap& map,
  const Eigen::VectorXd& targets,
  DeformationEnergy::Shapes shapes,
  double areaWeight,
  int fineness,
  const ProgressCallback& progress = {});

/// The number of squares along the longer side of such a lattice around a map of so many vertices. More
/// than there is use for are not made: for small maps it is the same with every fineness.
int latticeSquares(int vertices, int fineness);

} // namespace flattening
