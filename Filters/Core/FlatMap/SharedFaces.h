// SPDX-License-Identifier: GPL-3.0-or-later
/// The faces that a surface has in common with another.
#pragma once

#include "Mesh/ClosestPointTree.h"
#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace flattening
{

/// A face of another surface, and which of its corners lie where the corners of the face here do.
struct SharedFace
{
  int Face = -1; ///< -1: the other surface does not have the face
  std::array<int, 3> Corners{};
};

/// For each face of @p target the face of @p surface whose corners have the very same coordinates; the
/// first if there are several. Most faces decide whether the whole target is oriented like the surface
/// or the other way round. A face against that is shared only if none of the others has its place, as
/// two sheets may lie upon each other. Faces of which two corners coincide are not shared.
std::vector<SharedFace> sharedFaces(const TriangleMesh& surface, const TriangleMesh& target);

/// The corner of @p surface at which corner @p k of the face here lies.
SurfacePoint cornerOf(const TriangleMesh& surface, const SharedFace& shared, int k);

} // namespace flattening
