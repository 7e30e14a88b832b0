// SPDX-License-Identifier: GPL-3.0-or-later
/// Edge flips: better triangles between the same vertices.
#pragma once

#include "Mesh/EditableSurface.h"

#include <array>
#include <functional>
#include <vector>

namespace flattening
{

/// The smallest angle of a triangle, radians; 0 if it has no area.
double smallestAngle(const std::array<Kernel::Point_3, 3>& corners);

/// Whether the angle between two vectors is smaller than the one of the cosine; false if one of them is
/// 0.
bool isTiltedLess(const Kernel::Vector_3& a, const Kernel::Vector_3& b, double cosine);

/// Flips the inner edges among @p edges for which @p mayFlip is true, until no flip makes the smallest
/// of the six angles beside its edge larger. The surface must be flat to 11 degrees there, and no flip
/// makes an edge that exists already. Returns whether any edge was flipped.
bool flipWhileImproving(SurfaceMesh& mesh,
  const std::vector<SurfaceMesh::Edge_index>& edges,
  const std::function<bool(SurfaceMesh::Edge_index)>& mayFlip);

/// Flips edges around the vertices in the same way, where both faces beside an edge are parts of the
/// same original face, so that the surface stays as it is. Edges between two of the vertices are kept.
void flipInsideOriginalFaces(EditableSurface& surface,
  const std::vector<SurfaceMesh::Vertex_index>& vertices);

} // namespace flattening
