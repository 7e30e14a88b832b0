// SPDX-License-Identifier: GPL-3.0-or-later
/// From any set of triangles to one clean oriented disk: what everything else in this library asks for.
#pragma once

#include "Base/Progress.h"
#include "Disk/BoundaryChoice.h"
#include "Disk/GeodesicHole.h"
#include "Disk/PlaneCut.h"
#include "Handles/HandleRemoval.h"
#include "Mesh/DerivedMesh.h"
#include "Mesh/SurfaceComponents.h"
#include "Repair/SpikeRemoval.h"
#include "Repair/SurfaceRepair.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// What is done about handles and tunnels.
enum class HandleMode
{
  Remove, ///< cut and capped (removeHandles)
  Cut,    ///< cut open along a short graph of edges, nothing removed (shortCutGraph); a closed surface
          ///< gets no hole or seam besides, unless a point is given for it
  Error   ///< a TopologyError that names the genus
};

/// How the surface is cut.
enum class CutMode
{
  Hole, ///< a closed surface loses a geodesic disk (cutGeodesicHole)
  Seam, ///< a geodesic path is cut, nothing is lost (cutGeodesicSeam); a tube with two open ends
        ///< (endsOfTube) is cut from end to end (placeTubeSeam)
  Plane ///< one side of a plane is kept (cutAtPlane)
};

struct SurfaceToDiskOptions
{
  /// Points within this distance of each other are merged (input units); 0: those that coincide exactly.
  double MergeTolerance = 0.0;
  ComponentChoice Component;
  BoundaryChoice Boundary;
  /// Whether spikes, pits and fins of one voxel are flattened (flattenSpikesAndFins). Not if handles are
  /// cut.
  bool FlattenFolds = true;
  /// Longest boundary loop that is filled (input units); 0: the circumference of a circle of 5 % of the
  /// surface's area.
  double FillLengthLimit = 0.0;
  HandleMode Handles = HandleMode::Remove;
  CutMode Cut = CutMode::Hole;
  /// The hole that is cut if the component is closed or all but closed; its BoundaryVertices hold for
  /// every boundary.
  GeodesicHoleOptions Hole;
  /// Where the seam goes, in order (input units); none: a closed surface is cut between two ends of it
  /// (placeSeam), a tube from end to end, any other open one is not.
  std::vector<Eigen::Vector3d> SeamPoints;
  CuttingPlane Plane;
  /// Per point of the input: not 0 where no hole or seam may be placed; empty: anywhere. Cuts of handles
  /// and tubes do not keep off it.
  std::vector<char> RegionOfInterest;
  /// Without remeshing, smaller angles are opened by local changes (withoutSmallAngles), as slivers
  /// cannot be flattened well; degrees, 0 (as it is) to 15. Not if handles are cut.
  double SmallestAngle = 1.0;
  bool Remesh = false;
  /// Edge length of remeshing (input units); 0: RelativeEdgeLength times the mean edge length.
  double TargetEdgeLength = 0.0;
  double RelativeEdgeLength = 0.9;
  /// Whether the pairs of faces that intersect are counted, in the component and in the disk.
  bool CountSelfIntersections = true;
};

/// All that was changed, and what came of it. Lengths and areas in input units.
struct SurfaceToDiskReport
{
  RepairReport Repair;
  int Components = 0;
  double DroppedComponentArea = 0.0;
  int ReorientedFaces = 0; ///< faces of the component turned over
  FlattenedFolds Folds;
  int FilledHoles = 0;
  double FilledArea = 0.0;
  int Genus = 0; ///< before anything was done about it
  HandleRemovalReport Handles;
  double RemeshEdgeLength = 0.0; ///< 0 if not remeshed
  Eigen::Vector3d HoleCentre = Eigen::Vector3d::Zero();
  double HoleRadius = 0.0;     ///< geodesic; 0 if no hole was cut
  double SeamLength = 0.0;     ///< of the seam or cut graph; 0 if there is none
  double RemovedArea = 0.0;    ///< of the hole, or beyond the plane
  int RemovedRegionPoints = 0; ///< of the region of interest, that the hole took all the same
  int SeamRegionPoints = 0;    ///< of the region of interest, that cuts of handles or tubes run through
  int BoundaryVertices = 0;
  double BoundaryLength = 0.0;
  double SurfaceArea = 0.0;
  double SmallestAngle = 0.0;      ///< of any face, degrees
  int SelfIntersectionsBefore = 0; ///< pairs of faces of the repaired component
  int SelfIntersections = 0;       ///< of the disk
};

struct DiskSurface
{
  DerivedMesh Surface;
  std::vector<char> Seam; ///< per vertex: 1 on a seam
  SurfaceToDiskReport Report;
};

/// Repairs the triangles (repairTriangleSoup), keeps one component, orients it outward (orientOutward),
/// flattens spikes and fins (flattenSpikesAndFins), keeps one side of a plane if asked, fills its
/// boundaries but the chosen one (fillHoles), does away with handles, remeshes if asked
/// (remeshIsotropically), opens a surface that is closed, resolves its boundary, and checks the result
/// (requireDisk). A boundary shorter than that of the hole that would be cut is filled too, and the
/// surface opened there: so short a boundary cannot become that of the flat disk. An input's boundary
/// gets 8 vertices at least (refineBoundary), or Hole.BoundaryVertices if these are fewer.
/// @throws InvalidInput for coordinates that are not finite, zero area, options out of range or that
/// name what is not there; TopologyError if the component is one-sided, or has handles and they are
/// errors.
DiskSurface surfaceToDisk(const TriangleMesh& soup,
  const SurfaceToDiskOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
