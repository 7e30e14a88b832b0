// SPDX-License-Identifier: GPL-3.0-or-later
/// T-junctions: vertices in the middle of an open edge, where the surface has a crack without width.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Repair/FaceList.h"

namespace flattening
{

/// Splits every face with an open edge (an edge of one face only) at the ends of other open edges that
/// lie on it, so that the faces on the other side fit. A vertex lies on an edge if it is off the edge's
/// ends and no farther from the edge than @p tolerance (input units) or slivers::CapAltitude of its
/// length, whichever is more, nor than a tenth of the face's height over the edge. Parts inherit the
/// origin. Near a corner a vertex may lie on two edges of a face; what is beyond it at that corner is
/// dropped.
/// @param faces at least one; no face may repeat a vertex.
/// @returns the number of places where an edge was split.
int closeTJunctions(const Points3& vertices, FaceList& faces, double tolerance = 0.0);

} // namespace flattening
