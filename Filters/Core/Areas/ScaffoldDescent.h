// SPDX-License-Identifier: GPL-3.0-or-later
/// Brings a map with a free outline to its areas as a whole.
#pragma once

#include "Areas/RefinementTerms.h"
#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{

/// The map that minimises the refinement energy of the whole mesh (RefinementDescent), from @p start (n
/// x 2), which must be one-to-one. Its areas go to the targets in steps (AreaApproach), with a new
/// scaffold (OutlineScaffold) in each. The map remains one-to-one.
/// @param terms    of the mesh, with the edges of its boundary, in order, as their outline
/// @param targets  the areas that the faces should have (m, > 0), up to a common factor
/// @throws Cancelled, ConvergenceError.
Points2 descendInScaffold(const RefinementTerms& terms,
  const Points2& start,
  const Eigen::VectorXd& targets,
  const ProgressCallback& progress = {});

} // namespace flattening
