// SPDX-License-Identifier: GPL-3.0-or-later
/// Better triangles on the same vertices.
#pragma once

#include "Mesh/EditableSurface.h"

#include <array>
#include <vector>

namespace flattening
{

/// Radians; 0 for a triangle without area.
double smallestAngle(const std::array<Kernel::Point_3, 3>& corners);

/// Whether turning an inner edge over makes the smallest of the six angles larger, on a part of the
/// surface that is flat to 11 degrees, and makes no edge that exists already.
bool flipImproves(const SurfaceMesh& mesh, SurfaceMesh::Halfedge_index h);

/// Turns edges at the vertices over, while that improves angles, where both of their faces are parts of
/// the same original face: the surface stays as it is. Edges between two of the vertices are kept.
void flipInsideOriginalFaces(EditableSurface& surface,
  const std::vector<SurfaceMesh::Vertex_index>& vertices);

} // namespace flattening
