// SPDX-License-Identifier: GPL-3.0-or-later
/// A mesh whose vertices have places on an older surface.
#pragma once

#include "Mesh/ClosestPointWalk.h"

#include <vector>

namespace flattening
{

struct PlacedMesh
{
  TriangleMesh Mesh;
  /// The points of the older surface that the vertices lie on or, if they were moved off, belong to.
  std::vector<SurfacePoint> Places;
};

/// The mesh of @p walk, every vertex of which has its place on itself. @throws TopologyError if a vertex
/// belongs to no face.
PlacedMesh placedOnItself(const ClosestPointWalk& walk);

} // namespace flattening
