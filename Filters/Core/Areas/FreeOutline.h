// SPDX-License-Identifier: GPL-3.0-or-later
/// The free outline: an area-preserving map lets go of its domain, so that shapes are less distorted.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// A map with a free outline, and how it was found.
struct FreeOutlineResult
{
  Points2 Positions;      ///< n x 2, with the centroid of the map in the origin
  int Deformations = 0;   ///< number of smooth deformations; 0 if the map is as it was
  int Rounds = 0;         ///< number of passes of the refinement
  double ShareOff = 0.0;  ///< share of the faces whose area is off by more than 2 %
  int FlippedFaces = 0;   ///< faces not positively oriented (exact)
  bool Bijective = false; ///< whether no face is flipped and the outline does not cross itself (exact)
};

/// Begins with a one-to-one map @p positions (n x 2) of @p surface, a disk with the boundary @p loop.
/// Its faces have about the areas @p faceTargets (m, >= 0, up to a common factor). Smooth deformations
/// (smoothlyDeformed) lower the distortion of shapes and hold the areas of regions; rounds of the
/// refinement make the areas of the faces exact, while boundary vertices are as free as the others. No
/// step lets a face flip or the outline cross itself, and the map remains one-to-one. The map is
/// returned as it is if it is not one-to-one, if no deformation can be applied to it, or if shapes would
/// not be less distorted.
/// @p area (> 0) is what the map is to cover in the end. @p shapeWeight (> 0) is that of the face
/// refinement (RefinementTerms).
/// @throws Cancelled, ConvergenceError.
FreeOutlineResult freeOutline(const TriangleMesh& surface,
  const std::vector<int>& loop,
  const Points2& positions,
  const Eigen::VectorXd& faceTargets,
  double area,
  double shapeWeight,
  const ProgressCallback& progress = {});

} // namespace flattening
