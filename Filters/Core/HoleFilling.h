// SPDX-License-Identifier: GPL-3.0-or-later
/// Closes the boundaries of a surface that are not the one to be kept.
#pragma once

#include "DerivedMesh.h"
#include "Progress.h"

#include <vector>

namespace flattening
{

struct FilledSurface
{
  DerivedMesh Surface;
  int FilledHoles = 0;
  double FilledArea = 0.0; ///< input units squared
};

/// Length of a closed polyline of vertices, input units.
double loopLength(const Points3& vertices, const std::vector<int>& loop);

/// Covers every boundary loop of a connected oriented manifold but the longest (by length, input units).
/// Patches are of least dihedral angle and area (Liepa 2003, "Filling holes in meshes"), then refined to
/// the density of the surface around them (CGAL triangulate_hole, refine). Old vertices and faces stay,
/// in their order; the faces of patches have origin -1, their vertices are made of the loop's vertices.
FilledSurface fillHolesButLongest(const TriangleMesh& mesh, const ProgressCallback& progress = {});

} // namespace flattening
