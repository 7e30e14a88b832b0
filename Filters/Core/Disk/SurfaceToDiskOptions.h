// SPDX-License-Identifier: GPL-3.0-or-later
/// The options of surfaceToDisk, and its result.
#pragma once

#include "Disk/BoundaryChoice.h"
#include "Disk/GeodesicHole.h"
#include "Disk/PlaneCut.h"
#include "Disk/ReliefPlacement.h"
#include "Handles/HandleRemoval.h"
#include "Mesh/DerivedMesh.h"
#include "Mesh/SliverThresholds.h"
#include "Mesh/SurfaceComponents.h"
#include "Repair/SpikeRemoval.h"
#include "Repair/SurfaceRepair.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace flattening
{

/// What happens to handles and tunnels before the surface is opened.
enum class HandleMode
{
  Remove, ///< they are cut and capped (removeHandles)
  Keep,   ///< the surface keeps its shape, and one more cut opens the handles: a short graph of edges
          ///< (cutToDisk). It opens a closed surface too, which then gets a hole or a seam only if a
          ///< point is given for it
  Error   ///< a TopologyError names the genus
};

/// How the surface is cut. Handles that are kept need a cut graph besides, see HandleMode.
enum class CutMode
{
  Hole,   ///< a closed surface loses a geodesic disk (cutGeodesicHole)
  Seam,   ///< the surface is cut along a geodesic path and loses nothing (cutGeodesicSeam); a tube with
          ///< two open ends (endsOfTube) is cut from end to end (placeTubeSeam)
  Plane,  ///< one side of a plane is kept (cutAtPlane)
  Relief, ///< the surface is cut along a tree of geodesics where they lower the distortion most
          ///< (placeRelief, cutRelief) and loses nothing; of an open surface the tree starts at the
          ///< boundary
  Label,  ///< a part of the surface is removed, and its border becomes that of the disk
  Automatic ///< a cut whose place is given (SeamPoints, Hole.Centre); otherwise a closed surface gets
            ///< the opening that makes the best map, a relief that suits a disk or a free outline
            ///< (FreeOutline), or a hole if the region of interest leaves no room for a relief; an open
            ///< one keeps its boundary and gets a relief, too, if its strain is large
};

struct SurfaceToDiskOptions
{
  /// Points within this distance of each other are merged (input units, >= 0); 0: only points that
  /// coincide exactly.
  double MergeTolerance = 0.0;
  /// One flag per point of the input: not 0 on the banks of a seam that was cut before. They are never
  /// merged, and a disk with these flags, of which some or none are set, passes unchanged
  /// (passesUnchanged). Empty: no seam is known.
  std::vector<char> Banks;
  ComponentChoice Component;
  BoundaryChoice Boundary;
  /// Whether spikes, pits and fins of one voxel are flattened (flattenSpikesAndFins). Ignored if handles
  /// are kept.
  bool FlattenFolds = true;
  /// The longest boundary loop that is filled (input units, >= 0); 0: the circumference of a circle of
  /// 5 % of the surface's area.
  double FillLengthLimit = 0.0;
  HandleMode Handles = HandleMode::Remove;
  CutMode Cut = CutMode::Automatic;
  /// The hole that is cut if the component is closed or nearly closed (isPuncture). Its BoundaryVertices
  /// hold for every boundary that a cut makes.
  GeodesicHoleOptions Hole;
  /// Points through which the seam runs, in order (input units). If there is none, a closed surface is
  /// cut between two of its extremities (placeSeam), a tube from end to end, and any other open surface
  /// is not cut.
  std::vector<Eigen::Vector3d> SeamPoints;
  /// The numbers of the points with which a further path of the seam begins, and whether the points are
  /// those of polylines (GeodesicSeamOptions).
  std::vector<int> SeamPathStarts;
  bool SeamPointsAreDense = false;
  ReliefOptions Relief;
  /// Whether the flat map will have a free outline, for which Automatic cuts a longer relief than for a
  /// disk.
  bool FreeOutline = false;
  /// One flag per face of the input: not 0 where the surface is removed if Cut is Label.
  std::vector<char> Labelled;
  CuttingPlane Plane;
  /// One flag per point of the input: not 0 where no hole, seam or relief may be placed; empty:
  /// anywhere. Cut graphs and the seams of tubes do not avoid it.
  std::vector<char> RegionOfInterest;
  /// Without remeshing, angles below this one are opened by local changes (withoutSmallAngles), before
  /// the surface is cut and once more beside seams (openAnglesBesideSeam), because
  /// slivers cannot be flattened well; degrees, 0 (off) to 15. Ignored if handles are kept.
  double SmallestAngle = slivers::DiskAngle;
  bool Remesh = false;
  /// Edge length of remeshing (input units); 0: RelativeEdgeLength times the mean edge length.
  double TargetEdgeLength = 0.0;
  /// In mean edge lengths of the surface, > 0.
  double RelativeEdgeLength = 0.9;
  /// Whether the pairs of faces that intersect are counted, in the component and in the disk.
  bool CountSelfIntersections = true;
};

/// Checks the options that do not depend on what the surface looks like.
/// @throws InvalidInput if one is out of range, or flags do not fit the @p soup of triangles.
void requireValid(const SurfaceToDiskOptions& options, const TriangleMesh& soup);

/// The changes that were made, and measures of the disk. Lengths and areas are in input units.
struct SurfaceToDiskReport
{
  RepairReport Repair;
  int Components = 0;
  double DroppedComponentArea = 0.0;
  int ReorientedFaces = 0; ///< faces of the component whose orientation was reversed
  FlattenedFolds Folds;
  int FilledHoles = 0;
  double FilledArea = 0.0;
  int Genus = 0; ///< before handles were removed or cut
  HandleRemovalReport Handles;
  double RemeshEdgeLength = 0.0; ///< 0 if the surface was not remeshed
  double RemeshAreaChange = 0.0; ///< area after remeshing less that before
  Eigen::Vector3d HoleCentre = Eigen::Vector3d::Zero();
  double HoleRadius = 0.0; ///< geodesic; 0 if no hole was cut
  /// The area of the hole in mean faces of the surface that it was cut into; 0 if no hole was cut.
  /// Beside holes of fewer than some dozens of faces areas cannot be kept.
  double HoleFaces = 0.0;
  double SeamLength = 0.0;   ///< of the seam, the relief and the cut graph; 0 if there is none
  int ReliefBranches = 0;    ///< number of branches of the relief
  double ReliefLength = 0.0; ///< of all branches
  /// The strain (ConformalStrain) before and after the relief was cut; 0 without a relief.
  std::array<double, 2> ReliefStrain{ 0.0, 0.0 };
  /// How the surface was opened; none if its boundary or a cut graph alone is that of the disk.
  std::optional<CutMode> ChosenCut;
  std::string ReasonOfCut;     ///< why, as a sentence
  double RemovedArea = 0.0;    ///< of the hole, of the part beyond the plane and of the label
  int RemovedRegionPoints = 0; ///< points of the region of interest that the hole could not avoid
  int SeamRegionPoints = 0;    ///< points of the region of interest on a cut graph or the seam of a tube
  int BoundaryVertices = 0;
  double BoundaryLength = 0.0;
  double SurfaceArea = 0.0;
  double SmallestAngle = 0.0;      ///< of all faces, degrees
  int SelfIntersectionsBefore = 0; ///< pairs of intersecting faces in the repaired component
  int SelfIntersections = 0;       ///< pairs of intersecting faces in the disk
};

struct DiskSurface
{
  DerivedMesh Surface;
  std::vector<char> Seam; ///< per vertex: 1 on a seam or a cut graph
  /// Per vertex: the point of the uncut surface that it is a copy of, as its first copy; -1 off the
  /// seams (pointsOfSeam).
  std::vector<int> SeamPoint;
  std::vector<int> Boundary; ///< vertices, in the direction that has the surface on its left
  SurfaceToDiskReport Report;
};

} // namespace flattening
