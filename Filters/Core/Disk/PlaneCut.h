// SPDX-License-Identifier: GPL-3.0-or-later
/// Cuts a surface off along a plane, for example to one hemisphere of a brain.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

#include <Eigen/Core>

namespace flattening
{

struct CuttingPlane
{
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero();  ///< any point of the plane, input units
  Eigen::Vector3d Normal = Eigen::Vector3d::UnitX(); ///< towards the part that stays; any length
};

struct PlaneCutSurface
{
  DerivedMesh Surface;      ///< may have several components and boundary loops
  double RemovedArea = 0.0; ///< input units squared
};

/// Keeps the part of an oriented manifold, of any topology, on the side of the plane that the normal
/// points to. Faces are cut along the plane, after longest-edge bisection if they are too coarse. Where
/// it passes close to vertices they move onto it, and short edges along the cut are collapsed
/// (snapToLevel, conditionCut), so that no slivers are left: the surface changes by no more than the
/// faces along the cut, which stays in the plane; boundaries that the surface had before stay. Then the
/// longest boundary loop is refined (refineBoundary).
/// @param boundaryVertices that the longest boundary loop gets at least (>= 3).
/// @throws InvalidInput if the origin or normal is not finite, the normal is zero, or the plane misses:
/// all of the surface lies on one side.
PlaneCutSurface cutAtPlane(const TriangleMesh& mesh,
  const CuttingPlane& plane,
  int boundaryVertices = 128,
  const ProgressCallback& progress = {});

} // namespace flattening
