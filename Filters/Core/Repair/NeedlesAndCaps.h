// SPDX-License-Identifier: GPL-3.0-or-later
/// The removal of triangles without area: needles, which have an edge of almost no length, and caps,
/// which have a vertex on the opposite edge.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Repair/FaceList.h"

namespace flattening
{

struct RemovedSlivers
{
  int JoinedVertices = 0; ///< vertices joined to another one
  int Faces = 0;          ///< needles and caps
};

/// Removes needles and caps until there is none.
///
/// Needles: edges shorter than slivers::NeedleEdge of the longest edge of a face beside them are
/// collapsed. Of the vertices joined, the one with the smallest index stays, where it is.
///
/// Caps: a face whose altitude is below slivers::CapAltitude of its longest edge is dropped, and the
/// faces beyond that edge are split at the vertex that lies on it, which leaves no T-junction. Both
/// parts inherit the origin.
///
/// @param faces no face may repeat a vertex. Afterwards several may have the same vertices.
RemovedSlivers removeNeedlesAndCaps(const Points3& vertices, FaceList& faces);

} // namespace flattening
