// SPDX-License-Identifier: GPL-3.0-or-later
/// Target areas that straight-sided faces can have.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// Near a round boundary, faces that are stretched along it and thinner than the segment that their
/// longest side cuts off the disk cannot lie beside each other without being flipped: where a small hole
/// becomes the boundary, all are. @p targets (m), raised for such faces to a share of the segment's area
/// (side^3 / 12 for radius 1), and of the mean target at most, and scaled back to their sum. How long
/// sides will be is taken from @p positions, or from @p conformal stretched in proportion to the
/// distance from the centre if that is shorter.
Eigen::VectorXd resolvableAreas(const FaceMatrix& faces,
  const Points2& conformal,
  const Points2& positions,
  const Eigen::VectorXd& targets);

} // namespace flattening
