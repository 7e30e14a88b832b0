// SPDX-License-Identifier: GPL-3.0-or-later
/// What the energy of face refinement takes from the surface.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Between neighbours on the boundary, which are members of its loop.
struct BoundaryGap
{
  int First;
  int Second;
  double Share; ///< of the perimeter of the domain, by its length on the surface
};

/// Of a mesh or a part of it.
struct RefinementTerms
{
  FaceMatrix Faces;
  Eigen::MatrixX3d Cotangents;  ///< of the surface's angles; those of slivers are opened
  Eigen::VectorXd ShapeWeights; ///< per face
  std::vector<BoundaryGap> Gaps;

  /// @p loop of the boundary. @p shapeWeight >= 0 is that of faces which are no slivers.
  RefinementTerms(const TriangleMesh& surface,
    const std::vector<int>& loop,
    double perimeter,
    double shapeWeight);
  RefinementTerms() = default;
};

} // namespace flattening
