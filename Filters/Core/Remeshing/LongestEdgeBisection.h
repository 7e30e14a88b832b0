// SPDX-License-Identifier: GPL-3.0-or-later
/// Local refinement that keeps the surface as it is and the mesh conforming (Rivara 1984, "Algorithms
/// for refining triangular grids suitable for adaptive and multigrid techniques").
#pragma once

#include "Mesh/EditableSurface.h"

#include <vector>

namespace flattening
{

/// Edges are bisected to lengths above this share of the coordinates, about a hundred distances of
/// neighbouring doubles: a guard, as the middle of a shorter edge can be rounded to one of its ends.
constexpr double ShortestBisected = 2e-14;

/// Bisects the listed faces and the parts that they are split into, until none of them has an edge
/// longer than @p longestEdge (input units, > 0). A face is split at the middle of its longest edge
/// together with the neighbour there, after all bisections of neighbours that this takes (the
/// longest-edge propagation path), so that no angle falls below half of the smallest one of the input.
/// @throws InvalidInput if double precision does not hold edges so short at these coordinates.
void bisectLongEdges(EditableSurface& surface,
  const std::vector<EditableSurface::Face>& faces,
  double longestEdge);

/// Bisects the listed faces as bisectLongEdges does, down to @p wanted or to half of their longest edge,
/// whichever is longer, and returns that length. Repeated for the faces near a curve, it refines big
/// faces near the curve only.
double halveLongEdges(EditableSurface& surface,
  const std::vector<EditableSurface::Face>& faces,
  double wanted);

/// Gives the longest boundary loop of an oriented manifold at least @p minimumVertices vertices. Faces
/// with a vertex on the loop are bisected as by bisectLongEdges, until their edges are as long as the
/// mean edge of such a loop; parts of them that do not touch the loop stay large, so that the number of
/// new faces grows with that of the vertices. Nothing changes if the loop has as many vertices or if
/// there is no boundary.
DerivedMesh refineBoundary(const TriangleMesh& mesh, int minimumVertices);

} // namespace flattening
