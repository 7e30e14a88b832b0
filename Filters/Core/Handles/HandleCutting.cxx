// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HandleCutting.h"

#include "Base/Errors.h"
#include "Handles/HomologyLabels.h"
#include "Handles/RejectedLoops.h"

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

// Lengths of loops: at first and for a detour in mean edge lengths, from one search to the next.
constexpr double FirstLength = 12.0;
constexpr double LongestDetour = 24.0;
constexpr double LengthGrowth = 1.6;
constexpr int TriesPerClass = 10;
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

// Of classes given by their hashes, which are linear.
int rankOf(const std::set<std::uint64_t>& hashes)
{
  std::vector<std::uint64_t> basis;
  for (std::uint64_t hash : hashes)
  {
    for (const std::uint64_t b : basis)
    {
      hash = std::min(hash, hash ^ b);
    }
    if (hash != 0)
    {
      basis.push_back(hash);
    }
  }
  return static_cast<int>(basis.size());
}

class HandleCutter
{
public:
  HandleCutter(TracedSurface& surface, const CutAlong& cutAlong, ProgressCallback progress)
    : Surface(surface)
    , TryCut(cutAlong)
    , Progress(std::move(progress))
    , EdgeLength(meanLength(surface.halfedges()))
    , Labels(surface.halfedges())
    , Loops(surface.halfedges(), this->Labels)
    , HandlesAtStart(this->Labels.genus())
    , HandlesLabelled(this->Labels.genus())
    , Refused(LongestDetour * this->EdgeLength)
  {
  }

  std::vector<double> run()
  {
    double length = FirstLength * this->EdgeLength;
    while (this->Labels.genus() > 0)
    {
      const std::size_t before = this->Lengths.size();
      this->cutLoopsUpTo(length);
      const bool allSeen = this->Lengths.size() == before && !this->Loops.wasBounded();
      constexpr double Any = std::numeric_limits<double>::infinity();
      this->cutRefused(allSeen ? Any : length, Any);
      if (allSeen && this->Lengths.size() == before && !this->splitChords())
      {
        throw TopologyError("a handle of the surface near vertex " +
                            std::to_string(this->Loops.seeds().front()) +
                            " cannot be cut: subdivide the surface first, e.g. with Linear Subdivision");
      }
      length = std::max(LengthGrowth * length, this->Refused.shortest());
    }
    return this->Lengths;
  }

private:
  struct IsLonger
  {
    bool operator()(const SurfaceLoop& a, const SurfaceLoop& b) const
    {
      return a.Length != b.Length ? a.Length > b.Length : a.Seed > b.Seed;
    }
  };
  struct ClassAttempts
  {
    int Count = 0;
    int Fewest = std::numeric_limits<int>::max(); // intersections
  };
  using Queue = std::priority_queue<SurfaceLoop, std::vector<SurfaceLoop>, IsLonger>;

  const HalfedgeSurface& halfedges() const { return this->Surface.halfedges(); }

  double fraction() const { return static_cast<double>(this->Lengths.size()) / this->HandlesAtStart; }

  void cutLoopsUpTo(double length)
  {
    if (this->Labels.genus() < FewHandles * this->HandlesLabelled)
    {
      this->Labels = HomologyLabels(this->halfedges());
      this->HandlesLabelled = this->Labels.genus();
    }
    this->countAttempts();
    if (rankOf(this->Known) == 2 * this->Labels.genus()) // no more are to be expected
    {
      constexpr double Any = std::numeric_limits<double>::infinity();
      this->cutRefused(Any, Any);
      return;
    }
    this->Loops.Ignored = this->Known;
    this->RefusedFrom.clear();
    const double here = this->fraction();
    this->Found = Queue({},
      this->Loops.find(this->Loops.seeds(),
        length,
        [this, here](double, const char* stage)
        { return !this->Progress || this->Progress(here, stage); }));
    while (!this->Found.empty() && this->Labels.genus() > 0)
    {
      const SurfaceLoop loop = this->Found.top();
      this->Found.pop();
      this->cutRefused(length, loop.Length);
      if (loop.Length > this->Refused.limit())
      {
        break;
      }
      this->tryCut(loop);
      if (loop.Seed >= 0 && this->Labels.genus() > 0)
      {
        this->findAgain(loop.Seed);
      }
    }
  }

  void findAgain(int seed)
  {
    this->Loops.Ignored = this->RefusedFrom[seed];
    this->Loops.Ignored.insert(this->Known.begin(), this->Known.end());
    SurfaceLoop next = this->Loops.findAgain(seed, this->Refused.limit());
    if (!next.Halfedges.empty())
    {
      this->Found.push(std::move(next));
    }
  }

  void tryCut(SurfaceLoop loop)
  {
    if (!this->isUpToDate(loop))
    {
      return;
    }
    if (!this->Attempts.count(this->Loops.classHash(loop)))
    { // tightened, the others would become this one
      this->Loops.tighten(loop);
    }
    const std::uint64_t hash = this->Loops.classHash(loop);
    const auto earlier = this->Attempts.find(hash);
    const bool isFirst = earlier == this->Attempts.end();
    if (!isFirst && earlier->second.Count >= TriesPerClass)
    {
      return;
    }
    if (this->Refused.contains(loop))
    {
      this->RefusedFrom[loop.Seed].insert(hash);
      return;
    }
    const int fewest = isFirst ? std::numeric_limits<int>::max() : earlier->second.Fewest;
    const int intersections = this->cut(loop, 0, fewest);
    if (intersections > 0)
    {
      this->RefusedFrom[loop.Seed].insert(hash);
      this->Refused.add(loop, intersections > fewest ? std::numeric_limits<int>::max() : intersections);
      this->addAttempt(hash, intersections);
      if (isFirst && intersections > RejectedLoops::Few)
      {
        for (SurfaceLoop& other : this->Loops.findBeside(loop, this->Refused.limit()))
        {
          this->Found.push(std::move(other));
        }
      }
    }
  }

  void addAttempt(std::uint64_t hash, int intersections)
  {
    ClassAttempts& attempts = this->Attempts[hash];
    attempts.Fewest = std::min(attempts.Fewest, intersections);
    if (++attempts.Count == TriesPerClass || intersections > RejectedLoops::Few)
    {
      this->Known.insert(hash);
    }
  }

  // Every cut changes the classes.
  void countAttempts()
  {
    this->Attempts.clear();
    this->Known.clear();
    this->Refused.keepIf([this](const SurfaceLoop& loop) { return this->isUpToDate(loop); });
    this->Refused.visit([this](const SurfaceLoop& loop, int intersections)
      { this->addAttempt(this->Loops.classHash(loop), intersections); });
  }

  // Takes the best of the refused loops, see RejectedLoops::due.
  void cutRefused(double searched, double tried)
  {
    while (true)
    {
      const SurfaceLoop* loop = this->Refused.due(searched, tried);
      if (!loop)
      {
        return;
      }
      constexpr int Any = std::numeric_limits<int>::max();
      this->cut(SurfaceLoop(*loop), Any, Any);
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

  int cut(const SurfaceLoop& loop, int tolerated, int counted)
  {
    report(this->Progress, this->fraction(), "cutting handles");
    std::vector<int> vertices;
    for (const int h : loop.Halfedges)
    {
      vertices.push_back(this->halfedges().origin(h));
    }
    const CutOutcome outcome = this->TryCut(loop, tolerated, counted);
    if (outcome.FirstCopy >= 0)
    {
      this->Labels.followCut(this->halfedges(), loop.Halfedges, vertices, outcome.FirstCopy);
      this->Lengths.push_back(loop.Length);
      this->countAttempts();
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
  double EdgeLength;
  HomologyLabels Labels;
  ShortLoops Loops;
  int HandlesAtStart;
  int HandlesLabelled;
  std::vector<double> Lengths;
  Queue Found; // in this search
  RejectedLoops Refused;
  std::map<std::uint64_t, ClassAttempts> Attempts;    // of the refused loops
  std::set<std::uint64_t> Known;                      // classes whose loops were found already
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
