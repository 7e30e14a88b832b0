// SPDX-License-Identifier: GPL-3.0-or-later
/// From any set of triangles to one clean oriented disk: what everything else in this library asks for.
#pragma once

#include "DerivedMesh.h"
#include "GeodesicHole.h"
#include "Progress.h"
#include "SurfaceRepair.h"

#include <Eigen/Core>

#include <optional>

namespace flattening
{

struct SurfaceToDiskOptions
{
  /// Points within this distance of each other are merged (input units); 0: those that coincide exactly.
  double MergeTolerance = 0.0;
  /// Keep the component nearest to this point (input units); if absent, the one of the largest area.
  std::optional<Eigen::Vector3d> ComponentPoint;
  /// The hole that is cut if the component is closed or all but closed.
  GeodesicHoleOptions Hole;
  /// Edge length of isotropic remeshing (input units); 0: the mean edge length of the component; absent:
  /// no remeshing.
  std::optional<double> RemeshEdgeLength;
};

/// All that was changed, and what came of it. Lengths and areas in input units.
struct SurfaceToDiskReport
{
  RepairReport Repair;
  int Components = 0;
  int ReorientedFaces = 0; ///< faces of the component turned over
  int Genus = 0;
  int FilledHoles = 0;
  double FilledArea = 0.0;
  double RemeshEdgeLength = 0.0; ///< 0 if not remeshed
  Eigen::Vector3d HoleCentre = Eigen::Vector3d::Zero();
  double HoleRadius = 0.0;  ///< geodesic; 0 if no hole was cut
  double RemovedArea = 0.0; ///< of that hole
  int BoundaryVertices = 0;
  double BoundaryLength = 0.0;
  double SurfaceArea = 0.0;
};

struct DiskSurface
{
  DerivedMesh Surface;
  SurfaceToDiskReport Report;
};

/// Repairs the triangles (repairTriangleSoup), keeps one component, orients it outward (orientOutward),
/// fills its boundaries but the longest (fillHoles), remeshes it if asked (remeshIsotropically), opens
/// it if it is closed (cutGeodesicHole), and checks the result (requireDisk). A longest boundary shorter
/// than that of the hole that would be cut is filled too, and the surface opened there: so short a
/// boundary cannot become that of the flat disk.
/// @throws InvalidInput for coordinates that are not finite, zero area, options out of range;
/// TopologyError if the component has handles or is one-sided.
DiskSurface surfaceToDisk(const TriangleMesh& soup,
  const SurfaceToDiskOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
