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

/// Whether the angle between two vectors is smaller than the angle whose cosine is @p cosine; false if
/// one of the vectors is 0.
bool isTiltedLess(const Kernel::Vector_3& a, const Kernel::Vector_3& b, double cosine);

/// Flips inner edges among @p edges, again and again, until none of them may be flipped any more. An
/// edge is flipped if @p mayFlip is true for it and three conditions hold. The flip makes the smallest
/// of the six angles in the two faces beside the edge larger. It tilts the new faces by less than 11
/// degrees against the old ones, so that the surface keeps its shape. It makes no edge that exists
/// already. Returns whether any edge was flipped.
bool flipWhileImproving(SurfaceMesh& mesh,
  const std::vector<SurfaceMesh::Edge_index>& edges,
  const std::function<bool(SurfaceMesh::Edge_index)>& mayFlip);

/// Flips edges of the faces around @p vertices as flipWhileImproving does, but only edges whose two
/// faces are parts of the same original face, so that the surface keeps its shape. Edges between two of
/// @p vertices are kept.
void flipInsideOriginalFaces(EditableSurface& surface,
  const std::vector<SurfaceMesh::Vertex_index>& vertices);

} // namespace flattening
