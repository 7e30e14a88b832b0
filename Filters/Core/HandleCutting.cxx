// SPDX-License-Identifier: GPL-3.0-or-later
#include "HandleCutting.h"

#include "Errors.h"
#include "HomologyLabels.h"
#include "RefusedLoops.h"

#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

// Lengths of loops: first in mean edge lengths, then from one search to the next.
constexpr double FirstLength = 12.0;
constexpr double LengthGrowth = 1.6;
constexpr int TriesPerClass = 12;
// Labels become fewer only when they are computed anew: once this share of the handles is left.
constexpr double FewHandles = 0.3;

double meanLength(const HalfedgeSurface& surface)
{
  double sum = 0.0;
  for (int h = 0; h < surface.halfedgeCount(); ++h)
  {
    sum += surface.length(h);
  }
  return sum / surface.halfedgeCount();
}

class HandleCutter
{
public:
  HandleCutter(TracedSurface& surface, const CutAlong& cutAlong, ProgressCallback progress)
    : Surface(surface)
    , TryCut(cutAlong)
    , Progress(std::move(progress))
    , Labels(surface.halfedges())
    , Loops(surface.halfedges(), this->Labels)
    , HandlesAtStart(this->Labels.genus())
    , HandlesLabelled(this->Labels.genus())
  {
  }

  std::vector<double> run()
  {
    double length = FirstLength * meanLength(this->Surface.halfedges());
    while (this->Labels.genus() > 0)
    {
      const std::size_t before = this->Lengths.size();
      this->cutLoopsUpTo(length);
      const bool allSeen = this->Lengths.size() == before && !this->Loops.wasBounded();
      this->cutRefused(allSeen ? std::numeric_limits<double>::infinity() : length);
      if (allSeen && this->Lengths.size() == before && !this->splitChords())
      {
        throw TopologyError("a handle of the surface near vertex " +
                            std::to_string(this->Loops.seeds().front()) +
                            " cannot be cut: subdivide the surface first, e.g. with Linear Subdivision");
      }
      length *= LengthGrowth;
    }
    return this->Lengths;
  }

private:
  const HalfedgeSurface& halfedges() const { return this->Surface.halfedges(); }

  double fraction() const { return static_cast<double>(this->Lengths.size()) / this->HandlesAtStart; }

  void cutLoopsUpTo(double length)
  {
    if (this->Labels.genus() < FewHandles * this->HandlesLabelled)
    {
      this->Labels = HomologyLabels(this->halfedges());
      this->HandlesLabelled = this->Labels.genus();
    }
    if (this->Lengths.size() != this->CutsAtTries) // classes are others
    {
      this->CutsAtTries = this->Lengths.size();
      this->Tries.clear();
      this->Exhausted.clear();
    }
    this->Loops.Ignored = this->Exhausted;
    this->RefusedFrom.clear();
    const auto longer = [](const SurfaceLoop& a, const SurfaceLoop& b)
    { return a.Length != b.Length ? a.Length > b.Length : a.Seed > b.Seed; };
    const double here = this->fraction();
    std::priority_queue<SurfaceLoop, std::vector<SurfaceLoop>, decltype(longer)> queue(longer,
      this->Loops.find(this->Loops.seeds(),
        length,
        [this, here](double, const char* stage)
        { return !this->Progress || this->Progress(here, stage); }));
    while (!queue.empty() && this->Labels.genus() > 0)
    {
      const SurfaceLoop loop = queue.top();
      queue.pop();
      this->cutRefused(std::min(length, loop.Length));
      this->tryCut(loop);
      if (this->Labels.genus() == 0)
      {
        break;
      }
      this->Loops.Ignored = this->RefusedFrom[loop.Seed];
      this->Loops.Ignored.insert(this->Exhausted.begin(), this->Exhausted.end());
      SurfaceLoop next = this->Loops.findAgain(loop.Seed);
      if (!next.Halfedges.empty())
      {
        queue.push(std::move(next));
      }
    }
  }

  void tryCut(SurfaceLoop loop)
  {
    if (!this->isUpToDate(loop))
    {
      return;
    }
    const std::uint64_t hash = this->Loops.classHash(loop);
    if (this->Exhausted.count(hash))
    {
      return;
    }
    int& tries = this->Tries[hash];
    if (tries == 0) // tightened, the others would become this one
    {
      this->Loops.tighten(loop);
    }
    if (this->Refused.contains(loop))
    {
      this->RefusedFrom[loop.Seed].insert(hash);
      return;
    }
    const int intersections = this->cut(loop, 0);
    if (intersections > 0)
    {
      this->RefusedFrom[loop.Seed].insert(hash);
      if (++tries == TriesPerClass)
      {
        this->Exhausted.insert(hash);
      }
      this->Refused.add(std::move(loop), intersections);
    }
  }

  // Takes the best of the refused loops, now that all others up to a length were tried.
  void cutRefused(double length)
  {
    while (true)
    {
      this->Refused.keepIf([this](const SurfaceLoop& loop) { return this->isUpToDate(loop); });
      const SurfaceLoop* loop = this->Refused.due(length);
      if (!loop)
      {
        return;
      }
      this->cut(*loop, std::numeric_limits<int>::max());
    }
  }

  // Whether it still is a loop that could be cut, after the cuts since it was found.
  bool isUpToDate(const SurfaceLoop& loop) const
  {
    const HalfedgeSurface& surface = this->halfedges();
    for (std::size_t i = 0; i < loop.Halfedges.size(); ++i)
    {
      const int v = surface.tip(loop.Halfedges[i]);
      if (v != surface.origin(loop.Halfedges[(i + 1) % loop.Halfedges.size()]) || surface.onBoundary(v))
      {
        return false;
      }
    }
    return this->Loops.classHash(loop) != 0;
  }

  int cut(const SurfaceLoop& loop, int tolerated)
  {
    report(this->Progress, this->fraction(), "cutting handles");
    std::vector<int> vertices;
    for (const int h : loop.Halfedges)
    {
      vertices.push_back(this->halfedges().origin(h));
    }
    const CutOutcome outcome = this->TryCut(loop, tolerated);
    if (outcome.FirstCopy >= 0)
    {
      this->Labels.followCut(this->halfedges(), loop.Halfedges, vertices, outcome.FirstCopy);
      this->Lengths.push_back(loop.Length);
    }
    return outcome.Intersections;
  }

  // No edge may join boundary vertices across the surface. Its inner vertices then meet every handle.
  bool splitChords()
  {
    const int halfedges = this->halfedges().halfedgeCount();
    bool any = false;
    for (int h = 0; h < halfedges; ++h)
    {
      if (h < this->halfedges().twin(h) && this->halfedges().onBoundary(this->halfedges().origin(h)) &&
          this->halfedges().onBoundary(this->halfedges().tip(h)))
      {
        this->Surface.splitEdge(h);
        this->Labels.followSplit(this->halfedges(), h);
        any = true;
      }
    }
    return any;
  }

  TracedSurface& Surface;
  const CutAlong& TryCut;
  ProgressCallback Progress;
  HomologyLabels Labels;
  ShortLoops Loops;
  int HandlesAtStart;
  int HandlesLabelled;
  std::vector<double> Lengths;
  RefusedLoops Refused;
  std::map<std::uint64_t, int> Tries; // per class
  std::set<std::uint64_t> Exhausted;  // classes
  std::size_t CutsAtTries = 0;
  std::map<int, std::set<std::uint64_t>> RefusedFrom; // a seed in this search: classes
};

} // namespace

std::vector<double> cutHandles(TracedSurface& surface,
  const CutAlong& cutAlong,
  const ProgressCallback& progress)
{
  return HandleCutter(surface, cutAlong, progress).run();
}

} // namespace flattening
