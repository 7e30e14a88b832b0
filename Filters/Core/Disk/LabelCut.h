// SPDX-License-Identifier: GPL-3.0-or-later
/// Removes a labelled part of a surface, whose border becomes a boundary.
#pragma once

#include "Mesh/DerivedMesh.h"

#include <vector>

namespace flattening
{

struct LabelCutSurface
{
  DerivedMesh Surface;       ///< the rest, with the faces and vertices in their order
  double RemovedArea = 0.0;  ///< input units squared
  std::vector<int> Boundary; ///< the boundary loop of the rest to which the border belongs
};

/// Removes the labelled faces, and faces of the rest that hang on at a vertex alone.
/// @param mesh  connected oriented manifold
/// @param labelled  one flag per face
/// @throws InvalidInput if no face is labelled; TopologyError if all are, if the labelled faces are in
/// several pieces, or if the rest is or the border consists of several loops.
LabelCutSurface cutLabel(const TriangleMesh& mesh, const std::vector<char>& labelled);

} // namespace flattening
