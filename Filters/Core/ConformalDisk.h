// SPDX-License-Identifier: GPL-3.0-or-later
/// The conformal map of a surface of disk topology to the unit disk.
#pragma once

#include "Progress.h"
#include "RicciFlow.h"
#include "TriangleMesh.h"

namespace flattening
{

struct ConformalDiskOptions
{
  /// Interior vertex that goes to 0, or -1: the Moebius map that centres the surface area.
  int CenterVertex = -1;
  /// Boundary vertex that goes to angle 0, or -1: a rotation that depends on the surface alone.
  int BoundaryVertex = -1;
  RicciFlowOptions Flow;
};

struct ConformalDiskMap
{
  Points2 Positions;              ///< n x 2, unit disk; boundary vertices on the circle
  Eigen::VectorXd LogFactors;     ///< n, log of (flat length / surface length) at each vertex
  double MaxCurvatureError = 0.0; ///< radians, over the free vertices of the intrinsic triangulation
  double LayoutError = 0.0;       ///< greatest relative error of a laid out edge (see layoutError)
  double AddedLength = 0.0;       ///< length added to every edge to open degenerate faces; 0 mostly
  int NewtonIterations = 0;
  int Flips = 0;                  ///< intrinsic edge flips in all
  int InsertedBoundaryPoints = 0; ///< always 0: boundary edges flip with their mirror images
  int SpreadVertices = 0;         ///< whose true positions double precision hardly tells apart
  int FlippedFaces = 0;           ///< faces of the *original* connectivity not positively oriented
};

/// Maps @p mesh conformally to the unit disk. One boundary vertex is sent to infinity; the flow makes
/// the rest of the boundary straight, the surface is laid out in the half-plane and carried to the disk
/// by a Moebius map, which keeps discrete conformality exactly (Springborn, Schroeder, Pinkall 2008,
/// section 5.2; paper, Theorem 2).
/// @throws InvalidInput, TopologyError (see requireDisk), InvalidInput if CenterVertex is not an
/// interior or BoundaryVertex not a boundary vertex, ConvergenceError, Cancelled.
ConformalDiskMap conformalDiskMap(const TriangleMesh& mesh,
  const ConformalDiskOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
