// SPDX-License-Identifier: GPL-3.0-or-later
/// The result of all conformal maps.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Untangling/MapUntangling.h"

namespace flattening
{

struct ConformalDiskMap
{
  Points2 Positions;          ///< n x 2, in the unit disk, boundary vertices on the circle
  Eigen::VectorXd LogFactors; ///< n, log of (flat length / surface length) at each vertex
  /// Greatest error of an angle sum of the intrinsic triangulation (radians); NaN for methods that have
  /// no flat metric of their own, because angle sums of positions in the plane are always right.
  double MaxCurvatureError = 0.0;
  double LayoutError = 0.0; ///< greatest relative error of an embedded edge (see layoutError), or NaN
  double AddedLength = 0.0; ///< length added to every edge to open degenerate faces, mostly 0
  int NewtonIterations = 0;
  int BoundaryIterations = 0;  ///< of ConformalMethod::BoundaryFirst
  long long Flips = 0;         ///< number of intrinsic edge flips
  int SpreadVertices = 0;      ///< vertices moved apart in protrusions (see spreadProtrusions)
  UntanglingReport Untangling; ///< of the surface's faces, not the intrinsic ones
};

} // namespace flattening
