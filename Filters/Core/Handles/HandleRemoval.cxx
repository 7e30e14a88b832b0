// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HandleRemoval.h"

#include "Base/Errors.h"
#include "Handles/FaceIntersections.h"
#include "Handles/HandleCutting.h"
#include "Handles/LoopCapping.h"
#include "Mesh/MeshTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

// How far the copies of a loop move apart; less where that makes faces intersect.
constexpr double Steps[] = { 0.5, 0.25, 0.1, 0.03 };
// With more pairs than these the cap passes through a fold, whatever the step.
constexpr int Many = 64;

double areaOf(const HalfedgeSurface& surface,
  const FaceReplacement& faces,
  std::size_t begin,
  std::size_t end)
{
  const auto at = [&](int v) -> const Eigen::Vector3d&
  {
    const auto place = faces.Places.find(v);
    return place == faces.Places.end() ? surface.point(v) : place->second;
  };
  double twice = 0.0;
  for (std::size_t f = begin; f < end; ++f)
  {
    const std::array<int, 3>& t = faces.Faces[f];
    twice += (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).norm();
  }
  return 0.5 * twice;
}

double areaOf(const HalfedgeSurface& surface, const std::vector<int>& faces)
{
  double twice = 0.0;
  for (const int f : faces)
  {
    const Eigen::Vector3d& p = surface.point(surface.origin(3 * f));
    twice += (surface.point(surface.origin(3 * f + 1)) - p)
               .cross(surface.point(surface.origin(3 * f + 2)) - p)
               .norm();
  }
  return 0.5 * twice;
}

class HandleRemover
{
public:
  explicit HandleRemover(const TriangleMesh& mesh)
    : Original(mesh)
    , Surface(mesh)
    , Euler(this->halfedges().eulerCharacteristic())
    , Boundaries(this->halfedges().boundaryLoops())
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
  const HalfedgeSurface& halfedges() const { return this->Surface.halfedges(); }

  CutOutcome cutAndCap(const std::vector<int>& loop, int tolerated, int counted)
  {
    if (!this->Intersections || this->KnownFaces != this->halfedges().faceCount()) // edges were split
    {
      this->Intersections.emplace(this->halfedges());
      this->KnownFaces = this->halfedges().faceCount();
    }
    BestCut best;
    for (const auto& makeCap : { spanningCap, coneCap })
    {
      if (best.Cut && best.Pairs > Many && tolerated == 0) // a fold lies in the way, of a cone as well
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
    int Pairs = std::numeric_limits<int>::max(); // of faces that would intersect besides those that do
  };

  // Numbers of pairs above `counted` are not exact.
  template <typename MakeCap>
  void improve(BestCut& best, const std::vector<int>& loop, const MakeCap& makeCap, int counted) const
  {
    std::vector<int> vertices;
    std::vector<Eigen::Vector3d> points;
    for (const int h : loop)
    {
      vertices.push_back(this->halfedges().origin(h));
      points.push_back(this->halfedges().point(vertices.back()));
    }
    LoopCap cap = makeCap(points);
    if (cap.Faces.empty())
    {
      return;
    }
    splitEdgesOf(this->halfedges(), vertices, points, cap);
    constexpr int All = std::numeric_limits<int>::max();
    for (const double step : Steps)
    {
      CappedCut cut = capBothSides(this->halfedges(), loop, cap, step);
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
    this->Report.RemovedArea +=
      areaOf(this->halfedges(), faces.Replaced) - areaOf(this->halfedges(), faces, 0, old);
    this->Report.AddedArea += areaOf(this->halfedges(), faces, old, faces.Faces.size());

    this->Intersections->remove(faces.Replaced);
    const int firstFace = this->halfedges().faceCount();
    this->Surface.cut(loop);
    for (int side = 0; side < 2; ++side)
    {
      for (std::size_t i = 0; i < cut.Cap.Inside.size(); ++i)
      {
        std::map<int, double> weights;
        for (const auto& [corner, share] : cut.Cap.Weights[i])
        {
          for (const auto& [vertex, weight] : this->Surface.origin(cut.Vertices[corner]))
          {
            weights[vertex] += share * weight;
          }
        }
        this->Surface.addVertex(cut.Cap.Inside[i], { weights.begin(), weights.end() });
      }
    }
    for (const auto& [v, place] : faces.Places)
    {
      this->Surface.move(v, place);
    }
    this->Surface.addFaces(
      { faces.Faces.begin() + static_cast<std::ptrdiff_t>(old), faces.Faces.end() });
    this->Intersections->insert(faces.Replaced);
    std::vector<int> added(this->halfedges().faceCount() - firstFace);
    std::iota(added.begin(), added.end(), firstFace);
    this->Intersections->insert(added);
    this->KnownFaces = this->halfedges().faceCount();
    return cut.FirstCopy;
  }

  double greatestDisplacement() const
  {
    double greatest = 0.0;
    for (int v = 0; v < this->halfedges().vertexCount(); ++v)
    {
      const TracedSurface::Origin origin = this->Surface.origin(v);
      if (origin.size() == 1) // kept, or a copy
      {
        const Eigen::Vector3d before = this->Original.Vertices.row(origin[0].first).transpose();
        greatest = std::max(greatest, (this->halfedges().point(v) - before).norm());
      }
    }
    return greatest;
  }

  // Every cut takes one handle off, and does nothing else.
  void requireHandlesGone(const SurfaceWithoutHandles& result) const
  {
    const TriangleMesh& mesh = result.Surface.Mesh;
    const MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
    if (topology.Genus != 0 || topology.Components != 1 ||
        topology.eulerCharacteristic() != this->Euler + 2 * result.Report.Handles ||
        this->halfedges().boundaryLoops() != this->Boundaries)
    {
      throw TopologyError("the handles of the surface could not be removed, genus " +
                          std::to_string(topology.Genus) +
                          " is left: smooth the volume more before Contour");
    }
  }

  const TriangleMesh& Original;
  TracedSurface Surface;
  int Euler;
  std::vector<std::vector<int>> Boundaries;
  std::optional<FaceIntersections> Intersections;
  int KnownFaces = 0; // to them
  HandleRemovalReport Report;
};

} // namespace

SurfaceWithoutHandles removeHandles(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  return HandleRemover(mesh).run(progress);
}

} // namespace flattening
