// SPDX-License-Identifier: GPL-3.0-or-later
#include "HandleCutting.h"

#include "Errors.h"
#include "HomologyLabels.h"

#include <algorithm>
#include <queue>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

// Lengths of loops: first in mean edge lengths, then from one search to the next.
constexpr double FirstLength = 12.0;
constexpr double LengthGrowth = 1.6;
// A loop is offered for the last time once loops of up to this many times its length were.
constexpr double Patience = 1.5;
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
    bool last = false;
    while (this->Labels.genus() > 0)
    {
      const std::size_t before = this->Lengths.size();
      const bool found = this->cutLoopsUpTo(length, last);
      last = false;
      if (this->Lengths.size() == before && !this->Loops.wasBounded())
      {
        // All loops were seen.
        last = found;
        if (!found && !this->splitChords())
        {
          throw TopologyError(
            "a handle of the surface near vertex " + std::to_string(this->Loops.seeds().front()) +
            " cannot be cut: subdivide the surface first, e.g. with Linear Subdivision");
        }
      }
      this->FirstSearch = false;
      length *= LengthGrowth;
    }
    return this->Lengths;
  }

private:
  const HalfedgeSurface& halfedges() const { return this->Surface.halfedges(); }

  double fraction() const { return static_cast<double>(this->Lengths.size()) / this->HandlesAtStart; }

  // Whether there were any.
  bool cutLoopsUpTo(double length, bool last)
  {
    if (this->Labels.genus() < FewHandles * this->HandlesLabelled)
    {
      this->Labels = HomologyLabels(this->halfedges());
      this->HandlesLabelled = this->Labels.genus();
    }
    this->Loops.Ignored.clear();
    const auto longer = [](const SurfaceLoop& a, const SurfaceLoop& b)
    { return a.Length != b.Length ? a.Length > b.Length : a.Seed > b.Seed; };
    const std::vector<int> seeds = this->Loops.seeds();
    const double here = this->fraction();
    std::priority_queue<SurfaceLoop, std::vector<SurfaceLoop>, decltype(longer)> queue(longer,
      this->Loops.find(seeds,
        length,
        [this, here](double, const char* stage)
        { return !this->Progress || this->Progress(here, stage); }));
    const bool any = !queue.empty();
    while (!queue.empty())
    {
      SurfaceLoop loop = queue.top();
      queue.pop();
      const int seed = loop.Seed;
      if (this->isUpToDate(loop))
      {
        this->Loops.tighten(loop);
        // Loops so short were offered in the search before, unless this is the first.
        this->cut(loop, last || (!this->FirstSearch && Patience * loop.Length < length));
      }
      if (this->Labels.genus() == 0)
      {
        break;
      }
      SurfaceLoop next = this->Loops.findAgain(seed);
      if (!next.Halfedges.empty())
      {
        queue.push(std::move(next));
      }
    }
    return any;
  }

  // Whether it is still a loop to be cut, after the cuts and refusals since it was found.
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
    const std::uint64_t hash = this->Loops.classHash(loop);
    return hash != 0 && !this->Loops.Ignored.count(hash);
  }

  void cut(const SurfaceLoop& loop, bool last)
  {
    report(this->Progress, this->fraction(), "cutting handles");
    std::vector<int> vertices;
    for (const int h : loop.Halfedges)
    {
      vertices.push_back(this->halfedges().origin(h));
    }
    const int firstCopy = this->TryCut(loop, last);
    if (firstCopy < 0)
    {
      this->Loops.Ignored.insert(this->Loops.classHash(loop));
      return;
    }
    this->Labels.followCut(this->halfedges(), loop.Halfedges, vertices, firstCopy);
    this->Lengths.push_back(loop.Length);
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
  bool FirstSearch = true;
  std::vector<double> Lengths;
};

} // namespace

std::vector<double> cutHandles(TracedSurface& surface,
  const CutAlong& cutAlong,
  const ProgressCallback& progress)
{
  return HandleCutter(surface, cutAlong, progress).run();
}

} // namespace flattening
