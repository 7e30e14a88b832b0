// SPDX-License-Identifier: GPL-3.0-or-later
/// The conformal map of a surface of disk topology to the unit disk.
#pragma once

#include "ConformalDiskMap.h"
#include "Progress.h"
#include "RicciFlow.h"
#include "TriangleMesh.h"

namespace flattening
{

struct ConformalDiskOptions
{
  /// Interior vertex that goes to 0, or -1: the Moebius map that centres the surface area.
  int CenterVertex = -1;
  /// Boundary vertex that goes to angle 0, or -1: a rotation that depends on the surface alone.
  int BoundaryVertex = -1;
  RicciFlowOptions Flow;
};

/// Maps @p mesh conformally to the unit disk, by discrete Ricci flow (see ricciFlowDisk).
/// @throws InvalidInput, TopologyError (see requireDisk), InvalidInput if CenterVertex is not an
/// interior or BoundaryVertex not a boundary vertex, ConvergenceError, Cancelled.
ConformalDiskMap conformalDiskMap(const TriangleMesh& mesh,
  const ConformalDiskOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
