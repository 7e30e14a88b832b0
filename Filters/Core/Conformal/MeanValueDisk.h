// SPDX-License-Identifier: GPL-3.0-or-later
/// A map to the disk without flipped faces: Floater's mean value coordinates.
#pragma once

#include "Base/Progress.h"
#include "Conformal/ConformalDiskMap.h"
#include "Conformal/DiskCentring.h"

#include <vector>

namespace flattening
{

/// The boundary goes to the circle in proportion to its length, but for the Moebius map that centres the
/// surface; every inner vertex is the mean of its neighbours with mean value weights, which are positive
/// whatever the triangles (Floater 2003, "Mean value coordinates"; see ConvexCombinationDisk.h for where
/// that guarantees that no face is flipped). The map is not conformal: angles are distorted most along
/// the boundary, whose own shape is not used. It needs one factorization.
///
/// Faces without area are first opened (see AddedLength), so that all weights are finite.
/// MaxCurvatureError and LayoutError are NaN, LogFactors not computed.
/// @p mesh is a disk with the boundary @p loop (see requireDisk). The map is centred, not rotated, and
/// its flipped faces are not counted.
/// @throws ConvergenceError, Cancelled.
ConformalDiskMap meanValueDisk(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const DiskCentring& centring,
  const ProgressCallback& progress);

} // namespace flattening
