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
  BoundaryFirst, ///< linear and nearly as conformal: see BoundaryFirstDisk.h
  MeanValue      ///< linear, without flipped faces but not conformal: see MeanValueDisk.h
};

struct ConformalDiskOptions
{
  /// Interior vertex that goes to 0, or -1 for the Moebius map that centres the surface area.
  int CenterVertex = -1;
  /// Boundary vertex that goes to angle 0, or -1 for a rotation that depends on the surface alone.
  int BoundaryVertex = -1;
  RicciFlowOptions Flow; ///< used by ConformalMethod::RicciFlow only
  ConformalMethod Method = ConformalMethod::RicciFlow;
};

/// Maps @p mesh to the unit disk. All methods share the rules for the centre and the rotation. They work
/// with an intrinsic triangulation, whose triangles differ from the surface's faces; faces that are
/// flipped in the result are untangled (untangleMap) by moves of a few vertices, never of vertices on
/// the boundary or of the centre vertex.
/// @throws InvalidInput, TopologyError (see requireDisk); InvalidInput if CenterVertex is not an
/// interior vertex or BoundaryVertex not a boundary vertex; ConvergenceError; Cancelled.
ConformalDiskMap conformalDiskMap(const TriangleMesh& mesh,
  const ConformalDiskOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
