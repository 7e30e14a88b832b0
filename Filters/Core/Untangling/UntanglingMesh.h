// SPDX-License-Identifier: GPL-3.0-or-later
/// A flat map that is to be untangled.
#pragma once

#include "Mesh/VertexFaces.h"
#include "Untangling/TargetTriangles.h"

#include <vector>

namespace flattening
{

/// A flat map with everything that is needed to move its vertices.
struct UntanglingMesh
{
  const FaceMatrix& Faces;
  const std::vector<char>& Fixed; ///< per vertex: not 0 if it must stay
  const TargetTriangles& Targets;
  Points2& Positions;
  VertexFaces FacesOf;

  /// Whether face @p f is positively oriented, by exact arithmetic, and so far from flipping that it
  /// stays so when all positions are scaled or rotated and rounded again.
  bool safelyPositive(int f) const;

  /// The mean length of the sides of the faces around vertex @p v, in units of the map.
  double edgeLengthAt(int v) const;
};

} // namespace flattening
