// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/DiskOpening.h"

#include "Disk/CutGraph.h"
#include "Disk/EdgeCut.h"
#include "Disk/GeodesicHole.h"
#include "Disk/GeodesicSeam.h"
#include "Disk/ReliefCut.h"
#include "Disk/ReliefPlacement.h"
#include "Disk/SeamPlacement.h"
#include "Disk/TubeSeam.h"
#include "Handles/HandleLoops.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/LongestEdgeBisection.h"
#include "Repair/HoleFilling.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// The fewest vertices of a boundary that came with the input. Derived: a regular octagon covers nine
// tenths of its disk. With fewer, the flat map leaves more of the disk empty.
constexpr int LeastBoundaryVertices = 8;

double boundaryLength(const TriangleMesh& mesh)
{
  double length = 0.0;
  for (const std::vector<int>& loop : analyseTopology(mesh.Faces, mesh.vertexCount()).BoundaryLoops)
  {
    length += loopLength(mesh.Vertices, loop);
  }
  return length;
}

// Flags of vertices that are made of others: set if all, or any, of these others are flagged.
std::vector<char> flagsOf(const VertexOrigins& origins, const std::vector<char>& flags, bool all)
{
  std::vector<char> result(origins.rows(), all);
  for (int v = 0; v < origins.rows(); ++v)
  {
    for (VertexOrigins::InnerIterator origin(origins, v); origin; ++origin)
    {
      result[v] = all ? result[v] && flags[origin.col()] : result[v] || flags[origin.col()];
    }
  }
  return result;
}

// Counts the flagged vertices on the seam.
int countOnSeam(const std::vector<char>& flags, const CutSurface& cut)
{
  int count = 0;
  for (std::size_t v = 0; v < flags.size(); ++v)
  {
    count += flags[v] && cut.OnSeam[v] ? 1 : 0;
  }
  return count;
}

class Opening
{
public:
  Opening(DiskSurface& disk, const OpenEnds& ends, const SurfaceToDiskOptions& options)
    : Disk(disk)
    , Report(disk.Report)
    , Options(options)
    , Hole(options.Hole)
    , Ends(ends.Ends)
  {
    if (!this->Hole.Centre)
    {
      this->Hole.Centre = ends.Puncture;
    }
  }

  // A cut graph opens a closed surface too; a hole or a seam is cut as well if its place was given, and
  // a relief in any case.
  void open(const ProgressCallback& progress)
  {
    const bool cutsGraph = this->Report.Genus > 0 && this->Options.Handles == HandleMode::Keep;
    const bool cutsRelief = this->Options.Cut == CutMode::Relief;
    if (!cutsGraph)
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

private:
  const TriangleMesh& mesh() const { return this->Disk.Surface.Mesh; }
  bool isClosed() const { return this->Ends == OpenEnds::Kind::None; }
  bool isTube() const { return this->Ends == OpenEnds::Kind::Two; }

  bool hasPlaceOfCut() const
  {
    return this->Options.Cut == CutMode::Seam
             ? !this->Options.SeamPoints.empty()
             : this->Options.Cut == CutMode::Hole && this->Options.Hole.Centre;
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
    if (this->Options.Cut == CutMode::Seam &&
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
      this->resolveBoundary(std::min(LeastBoundaryVertices, this->Hole.BoundaryVertices));
    }
  }

  void cutSeam(const ProgressCallback& progress)
  {
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
    CutSurface cut = cutGeodesicSeam(this->mesh(), seam, subrange(progress, 0.4, 1.0)).Cut;
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
    const PlacedRelief placed =
      placeRelief(this->mesh(), this->avoided(), this->Options.Relief, subrange(progress, 0.0, 0.5));
    this->Report.ReliefStrain = { placed.StrainBefore, placed.StrainAfter };
    if (!placed.Tips.empty())
    {
      ReliefOpenedSurface relief =
        flattening::cutRelief(this->mesh(), placed.Tips, this->avoided(), subrange(progress, 0.5, 1.0));
      this->Report.ReliefBranches = relief.Branches;
      this->Report.ReliefLength = relief.Opened.Length;
      this->followSeam(std::move(relief.Opened.Cut));
    }
    this->resolveBoundary(this->Report.ReliefBranches > 0
                            ? this->Hole.BoundaryVertices
                            : std::min(LeastBoundaryVertices, this->Hole.BoundaryVertices));
  }

  // The region of interest on the surface as it is now.
  std::vector<char> avoided() const
  {
    return this->Options.RegionOfInterest.empty()
             ? std::vector<char>()
             : flagsOf(this->Disk.Surface.Vertices, this->Options.RegionOfInterest, false);
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

  // Carries the flags of an earlier seam over to the next surface: a vertex is on the seam if all that
  // it is made of are.
  void followFlags(const DerivedMesh& next)
  {
    if (!this->Disk.Seam.empty())
    {
      this->Disk.Seam = flagsOf(next.Vertices, this->Disk.Seam, true);
    }
  }

  void cutHole(const ProgressCallback& progress)
  {
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
  GeodesicHoleOptions Hole;
  OpenEnds::Kind Ends;
};

} // namespace

void openSurface(DiskSurface& disk,
  const OpenEnds& ends,
  const SurfaceToDiskOptions& options,
  const ProgressCallback& progress)
{
  Opening(disk, ends, options).open(progress);
}

} // namespace flattening
