// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/DiskOpening.h"

#include "Base/Errors.h"
#include "Disk/AutomaticCut.h"
#include "Disk/CutGraph.h"
#include "Disk/EdgeCut.h"
#include "Disk/GeodesicHole.h"
#include "Disk/GeodesicSeam.h"
#include "Disk/ReliefCut.h"
#include "Disk/ReliefPlacement.h"
#include "Disk/SeamAngles.h"
#include "Disk/SeamFlags.h"
#include "Disk/SeamPlacement.h"
#include "Disk/SeamSegments.h"
#include "Disk/TubeSeam.h"
#include "Handles/HandleLoops.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/LongestEdgeBisection.h"
#include "Repair/HoleFilling.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// The fewest vertices of a boundary that came with the input. Derived: a regular octagon covers nine
// tenths of its disk. With fewer, the flat map leaves more of the disk empty.
constexpr int LeastBoundaryVertices = 8;

// A seam of fewer mean edges that is also shorter than this share of the square root of the area is an
// error, if it opens a closed surface. A convention: two clicks at one place give such a seam; on a
// coarse surface a few edges can be long.
constexpr double FewestSeamEdges = 5.0;
constexpr double ShortestOpening = 0.05;
double boundaryLength(const TriangleMesh& mesh)
{
  double length = 0.0;
  for (const std::vector<int>& loop : analyseTopology(mesh.Faces, mesh.vertexCount()).BoundaryLoops)
  {
    length += loopLength(mesh.Vertices, loop);
  }
  return length;
}

// @throws InvalidInput if the seam that is to open a closed surface has only a few edges.
void requireLongSeam(const TriangleMesh& mesh, double length)
{
  const double edge = meanEdgeLength(mesh);
  const double size = std::sqrt(faceAreas(mesh.Vertices, mesh.Faces).sum());
  if (length < FewestSeamEdges * edge && length < ShortestOpening * size)
  {
    throw InvalidInput("the seam is " + formatted(length) + " long, " + formatted(length / edge) +
                       " edges of the surface, and a map cannot spread a whole surface from so short a "
                       "cut: choose points that are farther apart, as two clicks at one place are not");
  }
}

class Opening
{
public:
  // @param region  the region of interest on the surface of the disk
  Opening(DiskSurface& disk,
    const OpenEnds& ends,
    const SurfaceToDiskOptions& options,
    std::vector<char> region)
    : Disk(disk)
    , Report(disk.Report)
    , Options(options)
    , Region(std::move(region))
    , Hole(options.Hole)
    , Ends(ends.Ends)
  {
    if (!this->Hole.Centre)
    {
      this->Hole.Centre = ends.Puncture;
    }
    this->Cut = this->chosenCut();
  }

  void open(const ProgressCallback& progress)
  {
    this->cut(subrange(progress, 0.0, 0.95));
    this->openAngles(subrange(progress, 0.95, 1.0));
  }

private:
  const TriangleMesh& mesh() const { return this->Disk.Surface.Mesh; }
  bool isClosed() const { return this->Ends == OpenEnds::Kind::None; }
  bool cutsGraph() const { return this->Report.Genus > 0 && this->Options.Handles == HandleMode::Keep; }
  bool isTube() const { return this->Ends == OpenEnds::Kind::Two; }

  // A cut graph opens a closed surface too; a hole or a seam is cut as well if its place was given, and
  // a relief in any case.
  void cut(const ProgressCallback& progress)
  {
    const bool cutsRelief = this->Cut == CutMode::Relief;
    if (!this->cutsGraph())
    {
      cutsRelief ? this->cutRelief(progress) : this->cutHoleOrSeam(progress);
    }
    else if (cutsRelief)
    {
      this->cutGraph(subrange(progress, 0.0, 0.4));
      this->cutRelief(subrange(progress, 0.4, 1.0));
    }
    else if (this->hasPlaceOfCut())
    {
      this->cutHoleOrSeam(subrange(progress, 0.0, 0.4));
      this->cutGraph(subrange(progress, 0.4, 1.0));
    }
    else
    {
      this->cutGraph(progress);
    }
  }

  // Opens the angles that a seam has made smaller than was asked for.
  void openAngles(const ProgressCallback& progress)
  {
    if (!this->Disk.Seam.empty() && this->Options.Handles != HandleMode::Keep)
    {
      const bool remeshed = this->Options.Remesh;
      openAnglesBesideSeam(
        this->Disk, remeshed ? slivers::DiskAngle : this->Options.SmallestAngle, progress);
    }
  }

  // The way to cut, which Automatic leaves to the surface unless the place of a cut was given.
  CutMode chosenCut()
  {
    if (this->Options.Cut != CutMode::Automatic)
    {
      this->Report.ReasonOfCut = "Cut asks for it";
      if (this->Options.Cut == CutMode::Plane || this->Options.Cut == CutMode::Label)
      {
        this->Report.ChosenCut = this->Options.Cut;
      }
      return this->Options.Cut;
    }
    const CutChoice choice =
      automaticCut(this->Options, { this->isClosed(), this->cutsGraph(), this->regionIsEverywhere() });
    this->Report.ReasonOfCut = std::string("Automatic: ") + choice.Reason;
    return choice.Cut;
  }

  bool regionIsEverywhere() const
  {
    return !this->Region.empty() &&
           std::find(this->Region.begin(), this->Region.end(), 0) == this->Region.end();
  }

  bool hasPlaceOfCut() const
  {
    return this->Cut == CutMode::Seam ? !this->Options.SeamPoints.empty()
                                      : this->Cut == CutMode::Hole && this->Options.Hole.Centre;
  }

  void cutGraph(const ProgressCallback& progress)
  {
    HandleLoops handles = handleLoops(this->mesh(), subrange(progress, 0.0, 0.7));
    this->followFlags(handles.Surface);
    follow(this->Disk.Surface, std::move(handles.Surface));
    CutSurface cut = cutToDisk(this->mesh(), handles.Loops, subrange(progress, 0.7, 1.0));
    this->Report.SeamRegionPoints += countOnSeam(this->avoided(), cut);
    this->followSeam(std::move(cut));
    this->resolveBoundary(this->Hole.BoundaryVertices);
  }

  void cutHoleOrSeam(const ProgressCallback& progress)
  {
    if (this->Cut == CutMode::Seam &&
        (this->isClosed() || this->isTube() || !this->Options.SeamPoints.empty()))
    {
      this->cutSeam(progress);
    }
    else if (this->isClosed())
    {
      this->cutHole(progress);
    }
    else
    {
      // A plane or a label has cut the boundary, or it came with the input.
      const int least = this->Report.ChosenCut ? this->Hole.BoundaryVertices : LeastBoundaryVertices;
      this->resolveBoundary(std::min(least, this->Hole.BoundaryVertices));
    }
  }

  void cutSeam(const ProgressCallback& progress)
  {
    this->Report.ChosenCut = CutMode::Seam;
    GeodesicSeamOptions seam;
    seam.Points = this->Options.SeamPoints;
    seam.PathStarts = this->Options.SeamPathStarts;
    seam.AreDense = this->Options.SeamPointsAreDense;
    seam.BoundaryVertices = this->Hole.BoundaryVertices;
    if (this->isTube())
    {
      const MeshTopology topology = analyseTopology(this->mesh().Faces, this->mesh().vertexCount());
      seam.Points = placeTubeSeam(this->mesh(),
        topology.BoundaryLoops[0],
        topology.BoundaryLoops[1],
        subrange(progress, 0.0, 0.4));
    }
    else if (seam.Points.empty())
    {
      seam.Points = placeSeam(this->mesh(), this->avoided(), subrange(progress, 0.0, 0.4));
    }
    SeamOpenedSurface opened = cutGeodesicSeam(this->mesh(), seam, subrange(progress, 0.4, 1.0));
    if (this->isClosed())
    {
      requireLongSeam(this->mesh(), opened.Length);
    }
    CutSurface cut = std::move(opened.Cut);
    if (this->isTube() && !this->Options.RegionOfInterest.empty())
    {
      const std::vector<char> region = flagsOf(cut.Surface.Vertices, this->avoided(), false);
      this->Report.SeamRegionPoints = countOnSeam(region, cut) / 2; // the seam has two sides
    }
    this->followSeam(std::move(cut));
  }

  // Opens the surface along a relief. An open one on which no branch is worth its length stays as it is.
  void cutRelief(const ProgressCallback& progress)
  {
    const bool isAutomatic = this->Options.Cut == CutMode::Automatic;
    const PlacedRelief placed = placeRelief(this->mesh(),
      this->avoided(),
      isAutomatic ? automaticRelief(this->Options.Relief, this->Options.FreeOutline)
                  : this->Options.Relief,
      subrange(progress, 0.0, 0.5));
    this->Report.ReliefStrain = { placed.StrainBefore, placed.StrainAfter };
    if (!placed.Tips.empty())
    {
      ReliefOpenedSurface relief =
        flattening::cutRelief(this->mesh(), placed.Tips, this->avoided(), subrange(progress, 0.5, 1.0));
      this->Report.ReliefBranches = relief.Branches;
      // Without a branch there is no seam. A hole may be cut in its place, which carries no seam over.
      if (relief.Branches > 0)
      {
        this->Report.ReliefLength = relief.Opened.Length;
        this->followSeam(std::move(relief.Opened.Cut));
      }
    }
    if (this->Report.ReliefBranches > 0)
    {
      this->Report.ChosenCut = CutMode::Relief;
      this->resolveBoundary(this->Hole.BoundaryVertices);
    }
    else
    {
      this->openWithoutRelief(progress);
    }
  }

  void openWithoutRelief(const ProgressCallback& progress)
  {
    if (!analyseTopology(this->mesh().Faces, this->mesh().vertexCount()).BoundaryLoops.empty())
    {
      if (this->Options.Cut == CutMode::Automatic)
      {
        this->Report.ReasonOfCut = std::string("Automatic: ") + KeptBoundary;
      }
      this->resolveBoundary(std::min(LeastBoundaryVertices, this->Hole.BoundaryVertices));
      return;
    }
    if (this->Options.Cut != CutMode::Automatic)
    {
      throw InvalidInput(
        "there is no room for a relief: mark a smaller region of interest, or set Cut to Hole or Seam");
    }
    this->Report.ReasonOfCut = "Automatic: there is no room for a relief";
    this->cutHole(atFraction(progress, 1.0, "Cutting the hole"));
  }

  // The region of interest on the surface as it is now.
  std::vector<char> avoided() const
  {
    return this->Region.empty() ? std::vector<char>()
                                : flagsOf(this->Disk.Surface.Vertices, this->Region, false);
  }

  void followSeam(CutSurface&& cut)
  {
    const double before = boundaryLength(this->mesh());
    this->followFlags(cut.Surface);
    this->Disk.Seam.resize(cut.OnSeam.size(), 0);
    std::transform(cut.OnSeam.begin(),
      cut.OnSeam.end(),
      this->Disk.Seam.begin(),
      this->Disk.Seam.begin(),
      [](char now, char earlier) { return now || earlier; });
    follow(this->Disk.Surface, std::move(cut.Surface));
    this->Report.SeamLength += 0.5 * (boundaryLength(this->mesh()) - before);
  }

  // Carries the flags of an earlier seam over: a vertex is on it if all that it is made of are.
  void followFlags(const DerivedMesh& next)
  {
    if (!this->Disk.Seam.empty())
    {
      this->Disk.Seam = flagsOf(next.Vertices, this->Disk.Seam, true);
    }
  }

  void cutHole(const ProgressCallback& progress)
  {
    this->Report.ChosenCut = CutMode::Hole;
    this->Hole.Avoided = this->avoided();
    OpenedSurface opened = cutGeodesicHole(this->mesh(), this->Hole, progress);
    this->Report.HoleCentre = opened.Centre;
    this->Report.HoleRadius = opened.Radius;
    this->Report.RemovedArea += opened.RemovedArea;
    this->Report.RemovedRegionPoints = opened.RemovedAvoided;
    follow(this->Disk.Surface, std::move(opened.Surface));
  }

  // A cut graph makes only as many boundary vertices as it has edges, and a boundary of the input may
  // have only three.
  void resolveBoundary(int vertices)
  {
    DerivedMesh refined = refineBoundary(this->mesh(), vertices);
    if (refined.Mesh.vertexCount() > this->mesh().vertexCount())
    {
      this->followFlags(refined);
      follow(this->Disk.Surface, std::move(refined));
    }
  }

  DiskSurface& Disk;
  SurfaceToDiskReport& Report;
  const SurfaceToDiskOptions& Options;
  std::vector<char> Region;
  GeodesicHoleOptions Hole;
  OpenEnds::Kind Ends;
  CutMode Cut = CutMode::Hole;
};

} // namespace

void openSurface(DiskSurface& disk,
  const OpenEnds& ends,
  const SurfaceToDiskOptions& options,
  const ProgressCallback& progress)
{
  // The origins of the disk are those on the surface before it is cut, until the points of the seams are
  // known.
  DerivedMesh uncut = std::exchange(disk.Surface, derivedFromItself(disk.Surface.Mesh));
  std::vector<char> region = options.RegionOfInterest.empty()
                               ? std::vector<char>()
                               : flagsOf(uncut.Vertices, options.RegionOfInterest, false);
  Opening(disk, ends, options, std::move(region)).open(progress);
  disk.SeamPoint = pointsOfSeam(disk.Surface.Vertices, disk.Seam);
  follow(uncut, std::move(disk.Surface));
  disk.Surface = std::move(uncut);
}

} // namespace flattening
