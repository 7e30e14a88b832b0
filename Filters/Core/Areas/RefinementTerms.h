// SPDX-License-Identifier: GPL-3.0-or-later
/// The coefficients of the refinement energy that depend on the surface.
#pragma once

#include "Mesh/OutlineCrossings.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The interval between two neighbours on the boundary, given as indices into its loop.
struct BoundaryInterval
{
  int First;
  int Second;
  double Share;             ///< its part of the domain's perimeter, by length on the surface
  double LimitWeight = 0.0; ///< the weight of its stretch beyond a limit (RefinementEnergy)
};

/// The coefficients of a mesh or a part of it.
struct RefinementTerms
{
  FaceMatrix Faces;
  Eigen::MatrixX3d Cotangents;  ///< of the surface's angles (m x 3); slivers are opened first
  Eigen::VectorXd ShapeWeights; ///< per face (m)
  Eigen::VectorXd ShapeLimits;  ///< per face (m), infinite where there is none
  std::vector<BoundaryInterval> Intervals;
  std::vector<FlatEdge> Outline; ///< edges of a free boundary, which must not cross

  /// @p loop holds the boundary vertices. @p shapeWeight (>= 0) is for faces that are no slivers;
  /// slivers get less. @p perimeter is that of the domain.
  RefinementTerms(const TriangleMesh& surface,
    const std::vector<int>& loop,
    double perimeter,
    double shapeWeight);
  RefinementTerms() = default;

  /// Lets the boundary go, whose vertices @p loop holds: its edges become the outline instead of the
  /// intervals. No face has a shape limit.
  void freeBoundary(const std::vector<int>& loop);
  /// The same, and faces with two vertices on the boundary get a shape limit.
  void freeBoundaryWithoutNeedles(const std::vector<int>& loop);
};

} // namespace flattening
