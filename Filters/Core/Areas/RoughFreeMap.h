// SPDX-License-Identifier: GPL-3.0-or-later
/// A map with a free outline whose regions have about their areas.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace flattening
{

/// A one-to-one map of @p surface (n x 2) whose outline has taken the shape that distorts shapes least,
/// and whose regions have about the areas that they should have. The map of a coarse disk (coarseDisk)
/// is brought to its areas as a whole (descendInScaffold) and carried to the surface, where flipped
/// faces are untangled. Where the chart distorts shapes much, this is done more than once: each map is
/// the chart of the next coarse disk. A surface of few vertices is itself brought to its areas. Nothing
/// is returned if the map cannot be made one-to-one.
/// @param loop         the boundary vertices
/// @param chart        the one-to-one map to begin with (n x 2), best a nearly conformal one
/// @param faceTargets  the areas that the faces should have (m, > 0), up to a common factor
/// @param shapeWeight  of the face refinement (RefinementTerms), > 0
/// @throws Cancelled, ConvergenceError.
std::optional<Points2> roughFreeMap(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& chart,
  const Eigen::VectorXd& faceTargets,
  double shapeWeight,
  const ProgressCallback& progress = {});

} // namespace flattening
