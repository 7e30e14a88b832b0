// SPDX-License-Identifier: GPL-3.0-or-later
/// Closes boundaries of a surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

#include <limits>
#include <vector>

namespace flattening
{

struct HoleFillingOptions
{
  /// Input units, > 0: a loop that is longer is an error. Default: none is too long.
  double LongestLoop = std::numeric_limits<double>::infinity();
};

struct FilledSurface
{
  DerivedMesh Surface;
  int FilledHoles = 0;
  double FilledArea = 0.0; ///< input units squared
  int PiercingPatches = 0; ///< patches that intersect the surface, each other or themselves
};

/// Covers the listed boundary loops (as in MeshTopology) of an oriented manifold.
/// Patches are of least dihedral angle and area (Liepa 2003, "Filling holes in meshes"), then refined to
/// the density of the surface around them (CGAL triangulate_hole, refine). One that cuts through faces
/// is tried again without the refinement, then without the 2D triangulation of nearly flat loops, then
/// as a fan around the loop's centre; the one that cuts the fewest stays. Old vertices and faces stay,
/// in their order; the faces of patches have origin -1, their vertices are made of the loop's vertices.
/// @throws InvalidInput if a loop is longer than the limit.
FilledSurface fillHoles(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  const HoleFillingOptions& options,
  const ProgressCallback& progress = {});

/// With default options.
FilledSurface fillHoles(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  const ProgressCallback& progress = {});

} // namespace flattening
