// SPDX-License-Identifier: GPL-3.0-or-later
/// Keeps the part of a surface on one side of a plane, for example one hemisphere of a brain.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

#include <Eigen/Core>

namespace flattening
{

struct CuttingPlane
{
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero();  ///< any point of the plane, input units
  Eigen::Vector3d Normal = Eigen::Vector3d::UnitX(); ///< points to the part that is kept; any length
};

struct PlaneCutSurface
{
  DerivedMesh Surface;      ///< may have several components and boundary loops
  double RemovedArea = 0.0; ///< input units squared
};

/// Keeps the part of an oriented manifold, of any topology, on the side of the plane that the normal
/// points to. Faces are cut along the plane, after longest-edge bisection if they are too coarse.
/// Vertices near to the plane move onto it, and short edges along the cut are collapsed (snapToIsoline,
/// conditionCut), so that no slivers are left. Only faces along the cut change their shape; the cut
/// stays in the plane, and earlier boundaries stay as they are. Then the longest boundary loop is
/// refined (refineBoundary).
/// @param boundaryVertices the least number of vertices of the longest boundary loop (>= 3).
/// @throws InvalidInput if the origin or normal is not finite, the normal is zero, the whole surface
/// lies on one side of the plane up to rounding, or the cut is too short for double precision to hold
/// its vertices apart; Cancelled.
PlaneCutSurface cutAtPlane(const TriangleMesh& mesh,
  const CuttingPlane& plane,
  int boundaryVertices = 128,
  const ProgressCallback& progress = {});

} // namespace flattening
