// SPDX-License-Identifier: GPL-3.0-or-later
/// The removal of needles and caps from a mesh that stays on its surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"
#include "Remeshing/MeshOnSurface.h"

namespace flattening
{

/// Flips and collapses edges of the faces with an angle below @p degrees, and moves their vertices over
/// the old surface, until there is no such face or nothing helps. Every change makes the smallest of the
/// angles around it larger. The topology stays.
void removeSlivers(MeshOnSurface& surface, double degrees, const ProgressCallback& progress = {});

/// The same for a surface in which slivers are few, e.g. after it was cut. The changed vertices and
/// faces have the nearest points of @p mesh as origins, all others themselves.
/// @throws TopologyError if the mesh is no oriented manifold or has unused vertices.
DerivedMesh withoutSmallAngles(const TriangleMesh& mesh,
  double degrees,
  const ProgressCallback& progress = {});

/// The same, but the boundary keeps its vertices and edges, as those of the two banks of a seam belong
/// together, and no change makes an edge through the inside that joins two of its vertices.
DerivedMesh withoutSmallAnglesInside(const TriangleMesh& mesh,
  double degrees,
  const ProgressCallback& progress = {});

} // namespace flattening
