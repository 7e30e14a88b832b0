// SPDX-License-Identifier: GPL-3.0-or-later
/// Replaces the triangles of a surface by nearly equilateral ones.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

namespace flattening
{

/// Incremental isotropic remeshing (Botsch, Kobbelt 2004, "A remeshing approach to multiresolution
/// modeling"), @p iterations rounds of collapses, splits, Delaunay flips and tangential relaxation, each
/// guarded so that no face turns away from the old surface: edges stay short where it bends. Then angles
/// below 15 degrees are opened (removeSlivers) and faces that cut each other are taken apart
/// (removeSelfIntersections).
///
/// Vertices stay on the surface, found by walking over it (ClosestPointWalk), but for the few that had
/// to leave it for such a face; the boundary keeps its vertices but where it is long or almost straight;
/// topology stays. Every new vertex is made of the corners of the old face nearest to it, with
/// barycentric weights; every new face's origin is the old face nearest to its centroid.
///
/// CGAL's isotropic_remeshing takes three times as long at a million vertices, and on isosurfaces of
/// brains it left up to 41 pairs of faces that cut each other and angles below 1 degree.
/// @param targetEdgeLength input units, > 0.
/// @throws InvalidInput if the length is not positive and finite, or so large that fewer than 20
/// faces would be left.
DerivedMesh remeshIsotropically(const TriangleMesh& mesh,
  double targetEdgeLength,
  int iterations = 3,
  const ProgressCallback& progress = {});

} // namespace flattening
