// SPDX-License-Identifier: GPL-3.0-or-later
/// The map to the disk by mean value coordinates, in which no face is flipped.
#pragma once

#include "Base/Progress.h"
#include "Conformal/ConformalDiskMap.h"
#include "Conformal/DiskNormalisation.h"

#include <vector>

namespace flattening
{

/// Places the boundary on the circle in proportion to its length, but for the Moebius map that centres
/// the surface, and every interior vertex at the mean of its neighbours with mean value weights. These
/// are positive for all triangles (Floater 2003, "Mean value coordinates"), so that no face is flipped
/// (see ConvexCombinationDisk.h for the limits of that). The map is not conformal: angles are distorted
/// most along the boundary, whose own shape is not used. It takes one factorization.
///
/// Faces without area are opened first (see AddedLength), so that all weights are finite.
/// MaxCurvatureError and LayoutError are NaN; LogFactors and Untangling are not computed; the map is
/// centred, not rotated.
/// @p mesh is a disk with the boundary @p loop (see requireDisk).
/// @throws ConvergenceError, Cancelled.
ConformalDiskMap meanValueDisk(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const DiskCentring& centring,
  const ProgressCallback& progress);

} // namespace flattening
