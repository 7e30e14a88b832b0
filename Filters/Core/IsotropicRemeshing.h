// SPDX-License-Identifier: GPL-3.0-or-later
/// Replaces the triangles of a surface by nearly equilateral ones.
#pragma once

#include "DerivedMesh.h"
#include "Progress.h"

namespace flattening
{

/// Mean length of the edges, input units (edges between two faces count twice).
double meanEdgeLength(const TriangleMesh& mesh);

/// Incremental isotropic remeshing (Botsch, Kobbelt 2004; CGAL isotropic_remeshing), @p iterations
/// rounds. Vertices stay on the surface; the boundary is resampled along itself; topology stays. Every
/// new vertex is made of the corners of the old face nearest to it, with barycentric weights; every new
/// face's origin is the old face nearest to its centroid.
/// @param targetEdgeLength input units, > 0.
/// @throws InvalidInput if the length is not positive and finite, or so large that fewer than 20
/// faces would be left.
DerivedMesh remeshIsotropically(const TriangleMesh& mesh,
  double targetEdgeLength,
  int iterations = 3,
  const ProgressCallback& progress = {});

} // namespace flattening
