// SPDX-License-Identifier: GPL-3.0-or-later
/// Parts of a surface that are remeshed at the same time: how it is cut into parts and joined again.
#pragma once

#include "Remeshing/MeshOnSurface.h"

#include <vector>

namespace flattening
{

struct SurfacePart
{
  PlacedMesh Surface;
  /// Per vertex: the number of the vertex in the whole if other parts have it, too; else -1.
  std::vector<int> Shared;
  /// Per vertex: whether it must be kept (MeshOnSurface), so that the parts fit together afterwards:
  /// those that are shared, and the neighbours of those in which faces of the part meet from two sides,
  /// of which the part has copies.
  std::vector<char> Kept;
};

/// The parts of a manifold, each from the faces with its number.
/// @param partOfFace  per face: the number of its part, >= 0 and < @p count. A part may have no face.
std::vector<SurfacePart> cutIntoParts(const PlacedMesh& whole,
  const std::vector<int>& partOfFace,
  int count);

/// The part that remeshing @p part has left on @p surface.
SurfacePart remeshedPart(const SurfacePart& part, const MeshOnSurface& surface);

/// Joins parts at the vertices that they share.
/// @param vertexCount  of the mesh that was cut
PlacedMesh joinedParts(const std::vector<SurfacePart>& parts, int vertexCount);

} // namespace flattening
