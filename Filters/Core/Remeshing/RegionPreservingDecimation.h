// SPDX-License-Identifier: GPL-3.0-or-later
/// Decimation of a surface that keeps chosen regions as they are.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

#include <vector>

namespace flattening
{

/// Collapses edges outside of the regions until about @p contextFaces faces (> 0) are left there: CGAL's
/// edge_collapse with the cost and placement of Lindstrom and Turk 1998 ("Fast and memory efficient
/// polygonal simplification"), which preserve the volume and the boundary, and a bound on how far a face
/// may turn. The vertices of the regions and all faces around them stay as they are, and so do the faces
/// around a vertex in which fans of faces meet. The topology stays.
/// If there are no more than @p contextFaces faces outside, nothing changes.
///
/// A kept vertex has itself as origin, a new one the corners of the original face nearest to it; a
/// face's origin is itself or the original face nearest to its centroid.
/// @param inRegion one flag per vertex, not 0 in a region.
/// @throws InvalidInput if the flags do not fit, no vertex is in a region, contextFaces is below 1 or a
/// coordinate is not finite; TopologyError if the mesh is not an oriented manifold.
DerivedMesh decimateContext(const TriangleMesh& mesh,
  const std::vector<char>& inRegion,
  int contextFaces,
  const ProgressCallback& progress = {});

} // namespace flattening
