// SPDX-License-Identifier: GPL-3.0-or-later
/// Repairs faces of a surface in place, without remeshing it.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

namespace flattening
{

/// Opens angles below @p degrees (removeSlivers; 0: none), then takes faces that intersect apart
/// (removeSelfIntersections). All vertices and faces elsewhere stay as they are and are traced to
/// themselves, the changed ones to the nearest places of @p mesh. Topology and boundary stay.
/// @throws TopologyError if the mesh is no oriented manifold or has unused vertices.
DerivedMesh conditionFaces(const TriangleMesh& mesh,
  double degrees,
  const ProgressCallback& progress = {});

} // namespace flattening
