// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HandleRemoval.h"

#include "Base/Errors.h"
#include "Handles/CappedCut.h"
#include "Handles/FaceIntersections.h"
#include "Handles/HandleCutting.h"
#include "Mesh/MeshTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

// How far the copies of a loop move apart, as shares of the way to the centre of the faces around them;
// tried in this order until no faces intersect. Conventions: longer steps leave better triangles,
// shorter ones keep clear of parts nearby.
constexpr double Steps[] = { 0.5, 0.25, 0.1, 0.03 };
// More intersecting pairs than these mean that the cap passes through a fold, whatever the step: other
// steps and caps are not tried. A guard for time.
constexpr int Many = 64;

double areaOf(const std::vector<PlacedTriangle>& triangles, std::size_t begin, std::size_t end)
{
  double twice = 0.0;
  for (std::size_t f = begin; f < end; ++f)
  {
    const auto& [a, b, c] = triangles[f].Points;
    twice += (b - a).cross(c - a).norm();
  }
  return 0.5 * twice;
}

class HandleRemover
{
public:
  explicit HandleRemover(const TriangleMesh& mesh)
    : Original(mesh)
    , Before(analyseTopology(mesh.Faces, mesh.vertexCount()))
    , Surface(mesh)
  {
  }

  SurfaceWithoutHandles run(const ProgressCallback& progress)
  {
    this->Report.LoopLengths = cutHandles(
      this->Surface,
      [this](const SurfaceLoop& loop, int tolerated, int counted)
      { return this->cutAndCap(loop.Halfedges, tolerated, counted); },
      subrange(progress, 0.0, 0.95));
    this->Report.Handles = static_cast<int>(this->Report.LoopLengths.size());
    this->Report.GreatestDisplacement = this->greatestDisplacement();
    report(progress, 0.95, "checking the surface");
    SurfaceWithoutHandles result{ this->Surface.derived(), std::move(this->Report) };
    this->requireHandlesGone(result);
    report(progress, 1.0, "handles removed");
    return result;
  }

private:
  CutOutcome cutAndCap(const std::vector<int>& loop, int tolerated, int counted)
  {
    if (!this->Intersections || this->KnownFaces != this->Surface.faceCount()) // edges were split
    {
      this->Intersections.emplace(this->Surface);
      this->KnownFaces = this->Surface.faceCount();
    }
    BestCut best;
    for (const auto& makeCap : { spanningCap, coneCap })
    {
      if (best.Cut && best.Pairs > Many && tolerated == 0) // a cone would pass through the fold too
      {
        break;
      }
      this->improve(best, loop, makeCap, counted);
      if (best.Pairs <= 0)
      {
        return { this->apply(loop, *best.Cut), 0 };
      }
    }
    if (best.Pairs > tolerated)
    {
      return { -1, best.Pairs };
    }
    ++this->Report.PiercingCaps;
    this->Report.NewIntersections += best.Pairs;
    return { this->apply(loop, *best.Cut), best.Pairs };
  }

  struct BestCut
  {
    std::optional<CappedCut> Cut;
    int Pairs = std::numeric_limits<int>::max(); // of faces that would intersect but do not now
  };

  // Takes the cut with this kind of cap if fewer pairs would intersect. Numbers of pairs above `counted`
  // are not exact.
  template <typename MakeCap>
  void improve(BestCut& best, const std::vector<int>& loop, const MakeCap& makeCap, int counted) const
  {
    std::vector<int> vertices;
    std::vector<Eigen::Vector3d> points;
    for (const int h : loop)
    {
      vertices.push_back(this->Surface.source(h));
      points.push_back(this->Surface.point(vertices.back()));
    }
    LoopCap cap = makeCap(points);
    if (cap.Faces.empty())
    {
      return;
    }
    splitEdgesOf(this->Surface, vertices, points, cap);
    constexpr int All = std::numeric_limits<int>::max();
    for (const double step : Steps)
    {
      CappedCut cut = capBothSides(this->Surface, loop, cap, step);
      const int before = this->Intersections->count(cut.Faces.Replaced);
      const int enough = std::min(best.Pairs, counted);
      const int pairs =
        this->Intersections->countNew(cut.Faces, enough < All ? enough + before : All) - before;
      if (!best.Cut || pairs < best.Pairs)
      {
        best.Cut = std::move(cut);
        best.Pairs = pairs;
      }
      if (best.Pairs <= 0 || pairs > Many)
      {
        return;
      }
    }
  }

  int apply(const std::vector<int>& loop, const CappedCut& cut)
  {
    const FaceReplacement& faces = cut.Faces;
    const std::size_t old = faces.Replaced.size();
    const std::vector<PlacedTriangle> now = trianglesOf(this->Surface, faces.Replaced);
    const std::vector<PlacedTriangle> next = trianglesOf(this->Surface, faces);
    this->Report.RemovedArea += areaOf(now, 0, old) - areaOf(next, 0, old);
    this->Report.AddedArea += areaOf(next, old, next.size());

    this->Intersections->remove(faces.Replaced);
    const int firstFace = this->Surface.faceCount();
    this->Surface.cut(loop);
    this->addInnerVertices(cut);
    this->addInnerVertices(cut);
    for (const auto& [v, position] : faces.Positions)
    {
      this->Surface.move(v, position);
    }
    this->Surface.addFaces(
      { faces.Faces.begin() + static_cast<std::ptrdiff_t>(old), faces.Faces.end() });
    this->Intersections->insert(faces.Replaced);
    std::vector<int> added(this->Surface.faceCount() - firstFace);
    std::iota(added.begin(), added.end(), firstFace);
    this->Intersections->insert(added);
    this->KnownFaces = this->Surface.faceCount();
    return cut.FirstCopy;
  }

  // Adds the inner vertices of one cap.
  void addInnerVertices(const CappedCut& cut)
  {
    for (std::size_t i = 0; i < cut.Cap.Inside.size(); ++i)
    {
      std::vector<std::pair<Origin, double>> parts;
      for (const auto& [corner, share] : cut.Cap.Weights[i])
      {
        parts.emplace_back(this->Surface.origin(cut.Vertices[corner]), share);
      }
      this->Surface.addVertex(cut.Cap.Inside[i], combined(parts));
    }
  }

  double greatestDisplacement() const
  {
    double greatest = 0.0;
    for (int v = 0; v < this->Surface.vertexCount(); ++v)
    {
      const Origin origin = this->Surface.origin(v);
      if (origin.size() == 1) // kept, or a copy
      {
        const Eigen::Vector3d before = this->Original.Vertices.row(origin[0].first).transpose();
        greatest = std::max(greatest, (this->Surface.point(v) - before).norm());
      }
    }
    return greatest;
  }

  // Checks that every cut removed one handle and changed nothing else of the topology.
  void requireHandlesGone(const SurfaceWithoutHandles& result) const
  {
    const TriangleMesh& mesh = result.Surface.Mesh;
    const MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
    if (topology.Genus != 0 || topology.Components != 1 ||
        topology.eulerCharacteristic() !=
          this->Before.eulerCharacteristic() + 2 * result.Report.Handles ||
        topology.BoundaryLoops != this->Before.BoundaryLoops)
    {
      throw TopologyError("the handles of the surface could not be removed, genus " +
                          std::to_string(topology.Genus) +
                          " is left: smooth the volume more before Contour");
    }
  }

  const TriangleMesh& Original;
  const MeshTopology Before;
  HalfedgeSurface Surface;
  std::optional<FaceIntersections> Intersections;
  int KnownFaces = 0; // number of faces in Intersections
  HandleRemovalReport Report;
};

} // namespace

SurfaceWithoutHandles removeHandles(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  return HandleRemover(mesh).run(progress);
}

} // namespace flattening
