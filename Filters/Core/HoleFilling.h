// SPDX-License-Identifier: GPL-3.0-or-later
/// Closes boundaries of a surface.
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

/// Covers the listed boundary loops (as in MeshTopology) of an oriented manifold.
/// Patches are of least dihedral angle and area (Liepa 2003, "Filling holes in meshes"), then refined to
/// the density of the surface around them (CGAL triangulate_hole, refine). Old vertices and faces stay,
/// in their order; the faces of patches have origin -1, their vertices are made of the loop's vertices.
FilledSurface fillHoles(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  const ProgressCallback& progress = {});

} // namespace flattening
