// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/SurfaceToDisk.h"

#include "Base/Errors.h"
#include "Disk/DiskInFrame.h"
#include "Disk/DiskOpening.h"
#include "Disk/GivenDisk.h"
#include "Disk/LabelCut.h"
#include "Disk/TubeSeam.h"
#include "Mesh/CoordinateFrame.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SliverThresholds.h"
#include "Mesh/TrackedIntersections.h"
#include "Remeshing/IsotropicRemeshing.h"
#include "Remeshing/SelfIntersectionRemoval.h"
#include "Remeshing/SliverRemoval.h"
#include "Repair/CoincidentPoints.h"
#include "Repair/ConsistentOrientation.h"
#include "Repair/HoleFilling.h"

#include <algorithm>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

constexpr const char* RemedyForTube = "set Cut to Seam to cut a tube from end to end, ";
constexpr int RemeshIterations = 3; // a convention, as in CGAL's examples

// Counts pairs of intersecting faces. The two sides of a seam coincide, so their vertices are joined
// first.
int countIntersections(const TriangleMesh& mesh,
  TrackedIntersections& known,
  const ProgressCallback& progress)
{
  const std::vector<int> representative = coincidentPoints(mesh.Vertices, 0.0);
  TriangleMesh joined = mesh;
  joined.Faces = mesh.Faces.unaryExpr([&representative](int v) { return representative[v]; });
  known.update(joined, progress);
  return static_cast<int>(known.count());
}

// A surface on its way to a disk; make() lists the steps.
class DiskMaker
{
public:
  DiskMaker(const SurfaceToDiskOptions& options)
    : Options(options)
  {
  }

  DiskSurface make(const TriangleMesh& soup, const ProgressCallback& progress)
  {
    if (passesUnchanged(soup, this->Options))
    {
      this->Disk = givenDisk(soup, this->Options);
    }
    else
    {
      this->makeDisk(soup, progress);
    }
    report(progress, 0.95, "checking the disk");
    this->measure();
    report(progress, 0.98, "looking for self-intersections");
    if (this->Options.CountSelfIntersections)
    {
      this->Report.SelfIntersections =
        countIntersections(this->mesh(), this->Intersections, subrange(progress, 0.98, 1.0));
    }
    report(progress, 1.0, "done");
    return std::move(this->Disk);
  }

private:
  void makeDisk(const TriangleMesh& soup, const ProgressCallback& progress)
  {
    report(progress, 0.0, "repairing");
    this->repair(soup);
    report(progress, 0.15, "choosing the component");
    this->keepComponent();
    this->orient();
    if (this->Options.CountSelfIntersections)
    {
      report(progress, 0.17, "looking for self-intersections");
      this->Report.SelfIntersectionsBefore =
        countIntersections(this->mesh(), this->Intersections, subrange(progress, 0.17, 0.19));
    }
    if (this->Options.FlattenFolds && this->Options.Handles != HandleMode::Keep)
    {
      report(progress, 0.19, "flattening spikes and fins");
      this->Report.Folds = flattenSpikesAndFins(this->Disk.Surface.Mesh);
    }
    if (this->Options.Cut == CutMode::Plane)
    {
      this->keepSideOfPlane(subrange(progress, 0.2, 0.24));
    }
    else if (this->Options.Cut == CutMode::Label)
    {
      this->removeLabel();
    }
    this->closeBoundaries(subrange(progress, 0.24, 0.28));
    this->requireHandlesWanted();
    if (this->Options.Handles == HandleMode::Remove && this->Report.Genus > 0)
    {
      this->removeHandles(subrange(progress, 0.28, 0.4));
    }
    if (this->Options.Remesh)
    {
      this->remesh(subrange(progress, 0.4, 0.75));
    }
    else if (this->Options.Handles != HandleMode::Keep)
    {
      this->condition(subrange(progress, 0.4, 0.75));
    }
    this->open(subrange(progress, 0.75, 0.95));
    if (this->Options.Remesh && this->Disk.Seam.empty())
    {
      follow(this->Disk.Surface, withoutSmallAngles(this->mesh(), slivers::DiskAngle));
    }
  }

  const TriangleMesh& mesh() const { return this->Disk.Surface.Mesh; }
  double area() const { return faceAreas(this->mesh().Vertices, this->mesh().Faces).sum(); }

  // Drops all other faces and returns their area.
  double keepFaces(const std::vector<int>& faces)
  {
    const double before = this->area();
    follow(this->Disk.Surface, extractFaces(this->mesh(), faces));
    return before - this->area();
  }

  void repair(const TriangleMesh& soup)
  {
    RepairedSurface repaired =
      repairTriangleSoup(soup, this->Options.MergeTolerance, pointsKeptApart(soup, this->Options));
    this->Report.Repair = repaired.Report;
    this->Disk.Surface = std::move(repaired.Surface);
    this->Reversed = std::move(repaired.Reversed);
    this->OneSided = std::move(repaired.OneSided);
  }

  void keepComponent()
  {
    const SurfaceComponents components = connectedComponents(this->mesh());
    const std::vector<int> faces =
      components.faces(chooseComponent(this->mesh(), components, this->Options.Component));
    this->Report.Components = components.Count;
    std::vector<char> reversed;
    reversed.reserve(faces.size());
    for (const int f : faces)
    {
      reversed.push_back(this->Reversed[f]);
      if (this->OneSided[f])
      {
        throw TopologyError("the surface is one-sided, like a Moebius strip, at face " +
                            std::to_string(this->Disk.Surface.Faces[f]) +
                            ": cut it open there first, e.g. with Clip");
      }
    }
    this->Reversed = std::move(reversed);
    if (components.Count > 1)
    {
      this->Report.DroppedComponentArea = this->keepFaces(faces);
    }
    // Borders that lie on each other are closed where edges had more than two faces. The banks of an
    // earlier seam lie on each other, too, and must stay open.
    if (this->Report.Repair.SplitPoints > 0 && this->Options.Banks.empty())
    {
      follow(this->Disk.Surface, stitchCoincidentBorders(this->mesh()));
    }
  }

  void orient()
  {
    TriangleMesh& mesh = this->Disk.Surface.Mesh;
    const bool closed = analyseTopology(mesh.Faces, mesh.vertexCount()).BoundaryLoops.empty();
    this->Report.ReorientedFaces = orientOutward(mesh, this->Reversed, closed);
  }

  void keepSideOfPlane(const ProgressCallback& progress)
  {
    PlaneCutSurface side =
      cutAtPlane(this->mesh(), this->Options.Plane, this->Options.Hole.BoundaryVertices, progress);
    this->Report.RemovedArea = side.RemovedArea;
    follow(this->Disk.Surface, std::move(side.Surface));
    const SurfaceComponents parts = connectedComponents(this->mesh());
    if (parts.Count > 1)
    {
      ComponentChoice choice = this->Options.Component;
      if (choice.By == ComponentChoice::Rule::ByIndex)
      {
        choice.By = ComponentChoice::Rule::Largest;
      }
      this->Report.RemovedArea +=
        this->keepFaces(parts.faces(chooseComponent(this->mesh(), parts, choice)));
    }
  }

  // Removes the labelled faces, and notes their border.
  void removeLabel()
  {
    std::vector<char> labelled(this->mesh().faceCount(), 0);
    for (int f = 0; f < this->mesh().faceCount(); ++f)
    {
      const int origin = this->Disk.Surface.Faces[f];
      labelled[f] = origin >= 0 ? this->Options.Labelled[origin] : 0;
    }
    LabelCutSurface rest = cutLabel(this->mesh(), labelled);
    this->Report.RemovedArea = rest.RemovedArea;
    this->BorderOfLabel = rest.Boundary.front();
    follow(this->Disk.Surface, std::move(rest.Surface));
  }

  // The number of the loop that is not filled; -1 for none.
  int boundaryKept(const std::vector<std::vector<int>>& loops) const
  {
    if (this->BorderOfLabel < 0)
    {
      return chooseBoundary(this->mesh().Vertices, loops, this->Options.Boundary);
    }
    const auto hasBorder = [this](const std::vector<int>& loop)
    { return std::find(loop.begin(), loop.end(), this->BorderOfLabel) != loop.end(); };
    return static_cast<int>(std::find_if(loops.begin(), loops.end(), hasBorder) - loops.begin());
  }

  // Fills all boundary loops but the one that becomes the disk's, or the two ends of a tube.
  void closeBoundaries(const ProgressCallback& progress)
  {
    report(progress, 0.0, "filling holes");
    MeshTopology topology = analyseTopology(this->mesh().Faces, this->mesh().vertexCount());
    this->Report.Genus = topology.Genus;
    std::vector<std::vector<int>>& loops = topology.BoundaryLoops;
    const int kept = this->boundaryKept(loops);
    const double limit = this->fillLengthLimit();
    const std::vector<int> ends = kept >= 0 && this->seamMayOpenTube()
                                    ? endsOfTube(this->mesh().Vertices, loops)
                                    : std::vector<int>();
    const bool opensTube = !ends.empty() && this->Options.Cut == CutMode::Seam;
    if (opensTube)
    {
      this->Ends.Ends = OpenEnds::Kind::Two;
      loops.erase(loops.begin() + std::max(ends[0], ends[1]));
      loops.erase(loops.begin() + std::min(ends[0], ends[1]));
    }
    else if (kept >= 0)
    {
      if (this->BorderOfLabel < 0 &&
          isPuncture(this->mesh(), loops[kept], this->Options.Hole.AreaFraction, limit))
      {
        this->Ends.Puncture = centreOfLoop(this->mesh().Vertices, loops[kept]);
      }
      else
      {
        this->Ends.Ends = OpenEnds::Kind::One;
        loops.erase(loops.begin() + kept);
      }
    }
    if (!loops.empty())
    {
      const char* remedy = opensTube || ends.empty() ? "" : RemedyForTube;
      FilledSurface filled = fillHoles(this->mesh(), loops, limit, progress, remedy);
      this->Report.FilledHoles = filled.FilledHoles;
      this->Report.FilledArea = filled.FilledArea;
      this->Pierced |= filled.IntersectingPatches > 0;
      follow(this->Disk.Surface, std::move(filled.Surface));
    }
  }

  // The cut graph of handles that are kept needs a surface with one boundary at most: the second end of
  // such a tube is filled.
  bool seamMayOpenTube() const
  {
    return this->Options.Cut != CutMode::Plane && this->Options.Cut != CutMode::Label &&
           this->Options.SeamPoints.empty() &&
           (this->Report.Genus == 0 || this->Options.Handles == HandleMode::Remove);
  }

  double fillLengthLimit() const
  {
    return this->Options.FillLengthLimit > 0.0 ? this->Options.FillLengthLimit
                                               : longestFilledUnasked(this->mesh());
  }

  void requireHandlesWanted() const
  {
    const int genus = this->Report.Genus;
    if (genus > 0 && this->Options.Handles == HandleMode::Error)
    {
      throw TopologyError("the surface has genus " + std::to_string(genus) + ", that is " +
                          std::to_string(genus) +
                          (genus > 1 ? " handles or tunnels" : " handle or tunnel") +
                          ": set Handles to Remove or Cut, or smooth the volume more before Contour");
    }
  }

  void removeHandles(const ProgressCallback& progress)
  {
    SurfaceWithoutHandles removed = flattening::removeHandles(this->mesh(), progress);
    this->Report.Handles = removed.Report;
    this->Pierced |= removed.Report.PiercingCaps > 0;
    follow(this->Disk.Surface, std::move(removed.Surface));
  }

  void remesh(const ProgressCallback& progress)
  {
    this->Report.RemeshEdgeLength = this->Options.TargetEdgeLength != 0.0
                                      ? this->Options.TargetEdgeLength
                                      : this->Options.RelativeEdgeLength * meanEdgeLength(this->mesh());
    const double before = this->area();
    follow(this->Disk.Surface,
      remeshIsotropically(
        this->mesh(), this->Report.RemeshEdgeLength, RemeshIterations, progress, &this->Intersections));
    this->Report.RemeshAreaChange = this->area() - before;
  }

  void condition(const ProgressCallback& progress)
  {
    if (this->Pierced || flattening::smallestAngle(this->mesh()) < this->Options.SmallestAngle)
    {
      follow(this->Disk.Surface,
        conditionFaces(this->mesh(), this->Options.SmallestAngle, progress, &this->Intersections));
    }
  }

  void open(const ProgressCallback& progress)
  {
    const double meanFace = this->area() / this->mesh().faceCount();
    const double removed = this->Report.RemovedArea;
    openSurface(this->Disk, this->Ends, this->Options, progress);
    if (this->Report.HoleRadius > 0.0)
    {
      this->Report.HoleFaces = (this->Report.RemovedArea - removed) / meanFace;
    }
  }

  void measure()
  {
    this->Disk.Seam.resize(this->mesh().vertexCount(), 0);
    this->Disk.SeamPoint.resize(this->mesh().vertexCount(), -1);
    this->Disk.Boundary = requireDisk(this->mesh());
    this->Report.BoundaryVertices = static_cast<int>(this->Disk.Boundary.size());
    this->Report.BoundaryLength = loopLength(this->mesh().Vertices, this->Disk.Boundary);
    this->Report.SurfaceArea = this->area();
    this->Report.SmallestAngle = smallestAngle(this->mesh());
  }

  const SurfaceToDiskOptions& Options;
  DiskSurface Disk;
  SurfaceToDiskReport& Report = Disk.Report;
  std::vector<char> Reversed; // per face: whether the repair reversed its orientation
  std::vector<char> OneSided; // per face: whether its component is one-sided
  OpenEnds Ends;
  int BorderOfLabel = -1; // a vertex on the border of the label that was removed
  TrackedIntersections Intersections;
  bool Pierced = false; // whether a patch or a cap intersects other faces
};

DiskSurface diskInFrame(const TriangleMesh& soup,
  const SurfaceToDiskOptions& options,
  const CoordinateFrame& frame,
  const ProgressCallback& progress)
{
  const SurfaceToDiskOptions normalised = flattening::normalised(options, frame);
  try
  {
    DiskSurface disk = DiskMaker(normalised).make(frame.normalised(soup), progress);
    restoreUnits(disk, frame);
    return disk;
  }
  catch (const InvalidInput& error)
  {
    throwInUnits(error, frame);
  }
  catch (const TopologyError& error)
  {
    throwInUnits(error, frame);
  }
}

} // namespace

DiskSurface surfaceToDisk(const TriangleMesh& soup,
  const SurfaceToDiskOptions& options,
  const ProgressCallback& progress)
{
  requireValid(options, soup);
  requireUsableFaces(soup);
  const CoordinateFrame frame(soup);
  return frame.isIdentity() ? DiskMaker(options).make(soup, progress)
                            : diskInFrame(soup, options, frame, progress);
}

} // namespace flattening
