// SPDX-License-Identifier: GPL-3.0-or-later
/// Local changes that take intersecting faces of a surface apart.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"
#include "Mesh/TrackedIntersections.h"
#include "Remeshing/MeshOnSurface.h"

namespace flattening
{

/// Flips edges of faces that intersect, and moves their vertices to the means of their neighbours,
/// on the old surface or off it, until no faces intersect or nothing helps. Every change lowers the
/// number of intersecting pairs and makes no angle smaller than 10 degrees, unless it was before. Then
/// smooths the surface around the pairs that are left (smoothIntersections). Changes nothing where too
/// many faces intersect, or are near those that do (facesNear, MostNearOnePair). Reports for each pair.
/// Returns the number of pairs left.
/// @param known  the intersections of a mesh that has many of the surface's faces, which makes the
/// search
///        for pairs faster; those of the surface before the changes afterwards
int removeSelfIntersections(MeshOnSurface& surface,
  const ProgressCallback& progress = {},
  TrackedIntersections* known = nullptr);

/// Repairs the faces of a surface without remeshing it: opens angles below @p degrees (removeSlivers; 0:
/// none), then removes self-intersections. All other vertices and faces stay as they are and have
/// themselves as origins; the changed ones have the nearest points of @p mesh. The topology and the
/// boundary stay.
/// @param known  as for removeSelfIntersections
/// @throws TopologyError if the mesh is no oriented manifold or has unused vertices.
DerivedMesh conditionFaces(const TriangleMesh& mesh,
  double degrees,
  const ProgressCallback& progress = {},
  TrackedIntersections* known = nullptr);

} // namespace flattening
