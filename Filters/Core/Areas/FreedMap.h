// SPDX-License-Identifier: GPL-3.0-or-later
/// The refined map with a free outline, and the map in the domain that it comes from.
#pragma once

#include "Areas/FaceRefinement.h"
#include "Areas/FreeOutline.h"
#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <optional>

namespace flattening
{

/// A map in the domain, and the map with a free outline if there is one.
struct FreedMap
{
  FaceRefinementResult OnDomain;
  std::optional<FreeOutlineResult> Freed;
};

/// Refines @p map roughly (FaceRefinementOptions::IsRough) and frees its outline (freeOutline), which
/// makes errors of areas of its own that it has to correct in any case. If it leaves no more than 1 % of
/// the faces wrong, that is all. Otherwise the map in the domain is refined to the end, from the
/// beginning, and the map with a free outline counts only if no more than 1 % of the faces more are
/// wrong in it. So OnDomain is what refineFaces() makes if Freed is empty. A map that stops on the way
/// to the transported one (FaceRefinementOptions::StopsOnTheWay) is not freed.
/// @p faceTargets (m, >= 0) are the areas that the faces should have, up to a common factor.
/// @throws as refineFaces.
FreedMap freedMap(const TriangleMesh& surface,
  const TransportedMap& map,
  const Eigen::VectorXd& faceTargets,
  const FaceRefinementOptions& options,
  const ProgressCallback& progress = {});

} // namespace flattening
