// SPDX-License-Identifier: GPL-3.0-or-later
/// The area-preserving map whose outline is free, so that shapes are less distorted than in a domain.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace flattening
{

/// A map with a free outline, and how it was found.
struct FreeOutlineMap
{
  Points2 Positions;        ///< n x 2, with the centroid of the map in the origin
  int Rounds = 0;           ///< number of passes of the refinement
  double ShareOff = 0.0;    ///< share of the faces whose area is off by more than 2 %
  int FlippedFaces = 0;     ///< faces not positively oriented (exact)
  bool Bijective = false;   ///< whether no face is flipped and the outline does not cross itself (exact)
  bool WarmStarted = false; ///< whether it was made from an earlier map

  /// Whether it is one-to-one and the share of its faces that are wrong is greater than @p shareOff by
  /// a percent at most.
  bool keepsAreas(double shareOff) const;
};

/// Begins with the conformal map that has a free outline (MapsNearNaturalOutline). Its regions are
/// brought to their areas while its outline takes the shape that distorts shapes least (roughFreeMap),
/// and rounds of the refinement, in which boundary vertices are as free as the others, make the areas of
/// the faces exact. No step lets a face flip or the outline cross itself, and the map remains
/// one-to-one. Nothing is returned if there is no one-to-one map to begin with, or no such rough map.
/// @p surface is a disk with the boundary @p loop. The faces are to have the areas @p faceTargets (m,
/// >= 0, up to a common factor); @p area (> 0) is what the map is to cover. @p shapeWeight (> 0) is that
/// of the face refinement (RefinementTerms).
/// @p before  a map of this kind for other targets, or a map to a domain, to begin with instead (n x 2,
///            finite, at any scale). An empty array and a map that is not one-to-one are ignored.
/// @throws Cancelled, ConvergenceError.
std::optional<FreeOutlineMap> freeOutlineMap(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& before,
  const Eigen::VectorXd& faceTargets,
  double area,
  double shapeWeight,
  const ProgressCallback& progress = {});

} // namespace flattening
