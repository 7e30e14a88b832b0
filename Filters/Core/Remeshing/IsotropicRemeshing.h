// SPDX-License-Identifier: GPL-3.0-or-later
/// Replaces the triangles of a surface with nearly equilateral ones.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"
#include "Mesh/TrackedIntersections.h"

namespace flattening
{

/// Incremental isotropic remeshing (Botsch, Kobbelt 2004, "A remeshing approach to multiresolution
/// modeling"): @p iterations rounds of collapses, splits, Delaunay flips and tangential relaxation. No
/// operation turns a face away from the old surface, so that edges stay short where it bends. Then
/// angles below 15 degrees are opened (removeSlivers) and self-intersections removed
/// (removeSelfIntersections).
///
/// Vertices stay on the old surface (ClosestPointWalk), except the few that had to leave it where faces
/// intersected. The boundary keeps its vertices, except where it is almost straight, and gets new ones
/// where its edges are long. Where a face has two boundary edges, the third is flipped or split. The
/// topology stays. Every new vertex is made of the corners of the old
/// face nearest to it, with barycentric weights; the origin of a face is the old face nearest to its
/// centroid.
///
/// A surface of 300,000 faces or more is cut into parts, which are remeshed at the same time
/// (remeshedInParts); the result depends on the surface alone.
///
/// CGAL's isotropic_remeshing takes three times as long at a million vertices, and on isosurfaces of
/// brains it left up to 41 pairs of intersecting faces and angles below 1 degree.
/// @param targetEdgeLength input units, > 0.
/// @param iterations >= 0.
/// @param intersections  of the old surface, if it is not null; of the new one afterwards, but for what
///        removeSelfIntersections changed.
/// @throws InvalidInput if the length is not positive and finite, so large that fewer than 20 faces
/// would be left, or so small that more than 20 million points would be made, or more than
/// there is memory for.
DerivedMesh remeshIsotropically(const TriangleMesh& mesh,
  double targetEdgeLength,
  int iterations = 3,
  const ProgressCallback& progress = {},
  TrackedIntersections* intersections = nullptr);

} // namespace flattening
