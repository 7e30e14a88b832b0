// SPDX-License-Identifier: GPL-3.0-or-later
/// Cuts a surface open along some of its edges; nothing is removed.
#pragma once

#include "Mesh/DerivedMesh.h"

#include <array>
#include <vector>

namespace flattening
{

/// Two vertices that an edge joins, in any order.
using MeshEdge = std::array<int, 2>;

struct CutSurface
{
  /// Every face of the original, in its order. Vertices keep their index; the copies that the cut makes
  /// follow them, made of the original alone (weight 1).
  DerivedMesh Surface;
  std::vector<char> OnSeam; ///< per vertex: 1 at both ends of every edge of the seam
};

/// Around each vertex of the seam, every sector of faces between two edges of the seam (or the boundary)
/// gets a vertex of its own. Coordinates and areas stay as they are, bit for bit. A seam that ends
/// inside the surface leaves its last vertex whole; edges of the seam on the boundary change nothing.
/// @throws InvalidInput if the seam names a vertex or an edge that the mesh does not have.
CutSurface cutAlongEdges(const TriangleMesh& mesh, const std::vector<MeshEdge>& seam);

} // namespace flattening
