// SPDX-License-Identifier: GPL-3.0-or-later
/// Hole filling: covers boundary loops with patches of triangles.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

#include <limits>
#include <string>
#include <vector>

namespace flattening
{

struct FilledSurface
{
  DerivedMesh Surface;
  int FilledHoles = 0;
  double FilledArea = 0.0;     ///< area of all patches, input units squared
  int IntersectingPatches = 0; ///< patches that intersect the surface, each other or themselves
};

/// Covers the listed boundary loops (as in MeshTopology) of an oriented manifold.
///
/// Patches have the least dihedral angles and area (Liepa 2003, "Filling holes in meshes"; CGAL
/// triangulate_hole) and are refined to the density of the surface around them (CGAL refine). A patch
/// that intersects faces is made again without the refinement, then without the 2D triangulation of
/// nearly flat loops, then as a fan around the loop's centre; the patch with the fewest intersections
/// stays. Old vertices and faces stay, in their order. The faces of patches have the origin -1, their
/// vertices are made of the loop's vertices.
/// @param longestLoop input units, > 0. Default: no limit.
/// @param remedy what the message about a longer loop advises first.
/// @throws InvalidInput if a loop is longer.
FilledSurface fillHoles(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  double longestLoop = std::numeric_limits<double>::infinity(),
  const ProgressCallback& progress = {},
  const std::string& remedy = {});

} // namespace flattening
