// SPDX-License-Identifier: GPL-3.0-or-later
/// The conformal map to the disk by discrete Ricci flow.
#pragma once

#include "Base/Progress.h"
#include "Conformal/ConformalDiskMap.h"
#include "Conformal/DiskNormalisation.h"
#include "Conformal/RicciFlow.h"

#include <vector>

namespace flattening
{

/// Sends one boundary vertex to infinity. The flow makes the rest of the boundary straight; the surface
/// is then embedded in the half-plane and carried to the disk by a Moebius map, which keeps discrete
/// conformality exactly (Springborn, Schroeder, Pinkall 2008, section 5.2; paper, Theorem 2).
/// @p mesh is a disk with the boundary @p loop (see requireDisk). The map is centred, not rotated, and
/// Untangling is not computed.
/// @throws ConvergenceError, Cancelled.
ConformalDiskMap ricciFlowDisk(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const DiskCentring& centring,
  const RicciFlowOptions& options,
  const ProgressCallback& progress);

} // namespace flattening
