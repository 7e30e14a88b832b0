// SPDX-License-Identifier: GPL-3.0-or-later
/// The conformal map of a surface of disk topology to the unit disk.
#pragma once

#include "Base/Progress.h"
#include "Conformal/ConformalDiskMap.h"
#include "Conformal/RicciFlow.h"
#include "Mesh/TriangleMesh.h"

namespace flattening
{

enum class ConformalMethod
{
  RicciFlow,     ///< discrete uniformization: see RicciFlowDisk.h
  BoundaryFirst, ///< linear, nearly as conformal: see BoundaryFirstDisk.h
  MeanValue      ///< linear, not conformal, without flipped faces: see MeanValueDisk.h
};

struct ConformalDiskOptions
{
  /// Interior vertex that goes to 0, or -1: the Moebius map that centres the surface area.
  int CenterVertex = -1;
  /// Boundary vertex that goes to angle 0, or -1: a rotation that depends on the surface alone.
  int BoundaryVertex = -1;
  RicciFlowOptions Flow; ///< of ConformalMethod::RicciFlow alone
  ConformalMethod Method = ConformalMethod::RicciFlow;
};

/// Maps @p mesh to the unit disk. The methods have their centring and rotation in common. They work on
/// other triangles than the surface's: faces of the surface that they leave flipped are turned over
/// (untangleMap) by moves of a few vertices, not of those on the boundary and the centre vertex.
/// @throws InvalidInput, TopologyError (see requireDisk), InvalidInput if CenterVertex is not an
/// interior or BoundaryVertex not a boundary vertex, ConvergenceError, Cancelled.
ConformalDiskMap conformalDiskMap(const TriangleMesh& mesh,
  const ConformalDiskOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
