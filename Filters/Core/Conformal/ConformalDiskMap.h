// SPDX-License-Identifier: GPL-3.0-or-later
/// What every method for the conformal disk returns.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Untangling/MapUntangling.h"

namespace flattening
{

struct ConformalDiskMap
{
  Points2 Positions;          ///< n x 2, unit disk; boundary vertices on the circle
  Eigen::VectorXd LogFactors; ///< n, log of (flat length / surface length) at each vertex
  /// Radians, over the free vertices of the intrinsic triangulation; NaN for methods without a flat
  /// metric of their own: that of positions in the plane is flat whatever they are.
  double MaxCurvatureError = 0.0;
  double LayoutError = 0.0; ///< greatest relative error of a laid out edge (see layoutError); or NaN
  double AddedLength = 0.0; ///< length added to every edge to open degenerate faces; 0 mostly
  int NewtonIterations = 0;
  int BoundaryIterations = 0;     ///< of ConformalMethod::BoundaryFirst
  int Flips = 0;                  ///< intrinsic edge flips in all
  int SpreadVertices = 0;         ///< whose true positions double precision hardly tells apart
  UntanglingReport Repair;        ///< of the faces of the surface, not the intrinsic ones
  int FlippedFaces = 0;           ///< faces of the *original* connectivity not positively oriented
};

} // namespace flattening
