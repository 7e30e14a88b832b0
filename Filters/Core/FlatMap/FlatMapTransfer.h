// SPDX-License-Identifier: GPL-3.0-or-later
/// Carries a flattening over to another triangulation of the same surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

struct FlattenedSurface
{
  TriangleMesh Surface; ///< in space, oriented manifold
  Points2 Positions;    ///< flat position of each of its vertices
};

struct TransferredMap
{
  Points2 Positions;                ///< per vertex of the target; 0 if lost
  std::vector<char> Survived;       ///< per vertex of the target
  std::vector<SurfacePoint> Places; ///< on the flattened surface; meaningless if lost
  double Tolerance = 0.0;           ///< that was used
  double LargestDistance = 0.0;     ///< of a survivor from its place, in space, input units
};

/// Gives every vertex of @p target, e.g. the surface before it was repaired and remeshed, the flat
/// position of the point nearest to it on the flattened surface, with barycentric weights. A vertex is
/// lost if that is farther away than @p tolerance, if the normals there differ by more than 90 degrees
/// (the other side of a fold), or if it lies beyond the flattened surface's boundary (over a hole, or a
/// part that was cut off). Before that, the nearest point is looked for once more by walking over the
/// flattened surface from the places of the vertex' neighbours. A target that is oriented the other way
/// round as a whole is fine.
/// @param tolerance input units, >= 0; 0: half of the flattened surface's mean edge length.
/// @throws InvalidInput if a coordinate is not finite, the sizes do not fit, or no vertex survives.
TransferredMap transferFlatMap(const FlattenedSurface& flattened,
  const TriangleMesh& target,
  double tolerance = 0.0,
  const ProgressCallback& progress = {});

} // namespace flattening
