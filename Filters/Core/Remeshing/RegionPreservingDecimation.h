// SPDX-License-Identifier: GPL-3.0-or-later
/// A surface that is fine in some regions and coarse around them.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

#include <vector>

namespace flattening
{

/// Collapses edges outside of the regions until about @p contextFaces faces are left there: CGAL's
/// edge_collapse with the cost and placement of Lindstrom and Turk 1998 ("Fast and memory efficient
/// polygonal simplification"), which keep volume and boundary, and a bound on how far a face may turn.
/// Vertices of the regions and all faces around them stay as they are. Topology stays.
///
/// Kept vertices have themselves as origin, new ones the corners of the original face nearest to them;
/// a face's origin is itself or the original face nearest to its centroid. A context that has no more
/// faces than asked for is left as it is.
/// @param inRegion per vertex, not 0 in a region.
/// @throws InvalidInput if the flags do not fit, no vertex is in a region, contextFaces is below 1 or a
/// coordinate is not finite; TopologyError if the mesh is not an oriented manifold.
DerivedMesh decimateContext(const TriangleMesh& mesh,
  const std::vector<char>& inRegion,
  int contextFaces,
  const ProgressCallback& progress = {});

} // namespace flattening
