// SPDX-License-Identifier: GPL-3.0-or-later
/// The removal of small angles from a mesh that stays on its surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"
#include "Remeshing/MeshOnSurface.h"

namespace flattening
{

/// Flips and collapses edges of the faces with an angle below @p degrees and moves their vertices over
/// the old surface, until there is none or nothing helps. Every change makes the smallest of the angles
/// around larger. The topology stays.
void removeSlivers(MeshOnSurface& surface, double degrees, const ProgressCallback& progress = {});

/// The same for a surface that stays as it is elsewhere, e.g. after a boundary was cut. Changed vertices
/// and faces are traced to the nearest places of @p mesh, all others to themselves.
/// @throws TopologyError if the mesh is no oriented manifold or has unused vertices.
DerivedMesh withoutSmallAngles(const TriangleMesh& mesh,
  double degrees,
  const ProgressCallback& progress = {});

/// Whether the sum of the two angles opposite to a flipped edge becomes smaller: the Delaunay property.
bool opensAngles(const LocalChange& flip);

/// Distance between the two diagonals of a flip, input units: how much it changes the surface.
double flipHeight(const LocalChange& flip);

} // namespace flattening
