// SPDX-License-Identifier: GPL-3.0-or-later
/// A flat map whose flipped faces are to be turned over.
#pragma once

#include "Mesh/VertexFaces.h"
#include "Untangling/TargetTriangles.h"

#include <vector>

namespace flattening
{

/// What one must know of a flat map to move its vertices. The arguments of the constructor must live as
/// long as it does.
struct UntanglingMesh
{
  const FaceMatrix& Faces;
  const std::vector<char>& Fixed; ///< per vertex: not 0 if it must stay
  const TargetTriangles& Targets;
  Points2& Positions;
  VertexFaces FacesOf;

  UntanglingMesh(const FaceMatrix& faces,
    const std::vector<char>& fixed,
    const TargetTriangles& targets,
    Points2& positions)
    : Faces(faces)
    , Fixed(fixed)
    , Targets(targets)
    , Positions(positions)
    , FacesOf(faces, static_cast<int>(positions.rows()))
  {
  }

  /// Whether face @p f is positively oriented, exactly, and will be so when all positions are scaled or
  /// turned and rounded again.
  bool safelyPositive(int f) const;

  /// The mean length of the sides of the faces around vertex @p v.
  double edgeLengthAt(int v) const;
};

} // namespace flattening
