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

// The length up to which loops are searched first, in mean edge lengths, and its growth from one search
// to the next. Conventions: the first search finds the loops of noise; with longer steps the loops found
// may be farther from the shortest, with shorter ones there are more searches.
constexpr double FirstLength = 12.0;
constexpr double LengthGrowth = 1.6;
// How much longer a loop may be that is cut instead of a rejected one, in mean edge lengths. A guard:
// with no limit, long loops are cut far away from the handle, and late searches take long.
constexpr double LongestDetour = 24.0;
// Rejected loops of a class before its search ends. A guard for time: each try counts intersections.
constexpr int TriesPerClass = 10;
// Computing the labels anew makes them fewer, and with them the seeds to search from. It costs as much
// as one pass over the surface, so it is done only once this share of the labelled handles is left.
constexpr double FewHandles = 0.3;
constexpr double AnyLength = std::numeric_limits<double>::infinity();
constexpr int AnyNumber = std::numeric_limits<int>::max();

double meanLength(const HalfedgeSurface& surface)
{
  double sum = 0.0;
  for (int h = 0; h < surface.halfedgeCount(); ++h)
  {
    sum += surface.length(h);
  }
  return sum / surface.halfedgeCount();
}

// The rank of homology classes that are given by their hashes, by Gaussian elimination; hashes are
// linear.
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
  HandleCutter(HalfedgeSurface& surface, const CutAlong& cutAlong, ProgressCallback progress)
    : Surface(surface)
    , TryCut(cutAlong)
    , Progress(std::move(progress))
    , EdgeLength(meanLength(surface))
    , Labels(surface)
    , Loops(surface, this->Labels)
    , HandlesAtStart(this->Labels.genus())
    , HandlesLabelled(this->Labels.genus())
    , Rejected(LongestDetour * this->EdgeLength)
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
      this->cutRejected(allSeen ? AnyLength : length, AnyLength);
      if (allSeen && this->Lengths.size() == before && !this->splitChords())
      {
        throw TopologyError("a handle of the surface near vertex " +
                            std::to_string(this->Loops.seeds().front()) +
                            " cannot be cut: subdivide the surface first, e.g. with Linear Subdivision");
      }
      length = std::max(LengthGrowth * length, this->Rejected.shortest());
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
    int Fewest = AnyNumber; // pairs of faces that would intersect
  };
  using Queue = std::priority_queue<SurfaceLoop, std::vector<SurfaceLoop>, IsLonger>;

  double fraction() const { return static_cast<double>(this->Lengths.size()) / this->HandlesAtStart; }

  // Searches the surface once for loops up to @p length and tries to cut them, the shortest first.
  // Ignores classes of loops that have been given up.
  void cutLoopsUpTo(double length)
  {
    if (this->Labels.genus() < FewHandles * this->HandlesLabelled)
    {
      this->Labels = HomologyLabels(this->Surface);
      this->HandlesLabelled = this->Labels.genus();
    }
    this->countAttempts();
    if (rankOf(this->Known) == 2 * this->Labels.genus()) // no other class is left to search
    {
      this->cutRejected(AnyLength, AnyLength);
      return;
    }
    this->Loops.Ignored = this->Known;
    this->RejectedFrom.clear();
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
      this->cutRejected(length, loop.Length);
      if (loop.Length > this->Rejected.limit())
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
    this->Loops.Ignored = this->RejectedFrom[seed];
    this->Loops.Ignored.insert(this->Known.begin(), this->Known.end());
    SurfaceLoop next = this->Loops.findAgain(seed, this->Rejected.limit());
    if (!next.Halfedges.empty())
    {
      this->Found.push(std::move(next));
    }
  }

  // Cuts along the loop if that makes no faces intersect; otherwise notes the loop as rejected. Skips a
  // loop that can no longer be cut, and one of a class that was tried often enough.
  void tryCut(SurfaceLoop loop)
  {
    if (!this->isUpToDate(loop))
    {
      return;
    }
    if (!this->Attempts.count(this->Loops.classHash(loop)))
    { // only the first loop of a class is tightened: the others would become the same loop
      this->Loops.tighten(loop);
    }
    const std::uint64_t hash = this->Loops.classHash(loop);
    const auto earlier = this->Attempts.find(hash);
    const bool isFirst = earlier == this->Attempts.end();
    if (!isFirst && earlier->second.Count >= TriesPerClass)
    {
      return;
    }
    if (this->Rejected.contains(loop))
    {
      this->RejectedFrom[loop.Seed].insert(hash);
      return;
    }
    const int fewest = isFirst ? AnyNumber : earlier->second.Fewest;
    const int intersections = this->cut(loop, 0, fewest);
    if (intersections > 0)
    {
      this->RejectedFrom[loop.Seed].insert(hash);
      this->Rejected.add(loop, intersections > fewest ? AnyNumber : intersections);
      this->addAttempt(hash, intersections);
      if (isFirst && intersections > RejectedLoops::Few)
      {
        for (SurfaceLoop& other : this->Loops.findBeside(loop, this->Rejected.limit()))
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

  // Counts the rejected loops of each class anew, as every cut changes the classes.
  void countAttempts()
  {
    this->Attempts.clear();
    this->Known.clear();
    this->Rejected.keepIf([this](const SurfaceLoop& loop) { return this->isUpToDate(loop); });
    this->Rejected.visit([this](const SurfaceLoop& loop, int intersections)
      { this->addAttempt(this->Loops.classHash(loop), intersections); });
  }

  // Cuts rejected loops for which there is no better one, see RejectedLoops::due.
  void cutRejected(double searched, double tried)
  {
    while (const SurfaceLoop* loop = this->Rejected.due(searched, tried))
    {
      this->cut(SurfaceLoop(*loop), AnyNumber, AnyNumber);
    }
  }

  // Whether the loop can still be cut, after the cuts since it was found.
  bool isUpToDate(const SurfaceLoop& loop) const
  {
    const std::size_t n = loop.Halfedges.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const int v = this->Surface.target(loop.Halfedges[i]);
      if (v != this->Surface.source(loop.Halfedges[(i + 1) % n]) || this->Surface.onBoundary(v))
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
      vertices.push_back(this->Surface.source(h));
    }
    const CutOutcome outcome = this->TryCut(loop, tolerated, counted);
    if (outcome.FirstCopy >= 0)
    {
      this->Labels.followCut(this->Surface, loop.Halfedges, vertices, outcome.FirstCopy);
      this->Lengths.push_back(loop.Length);
      this->countAttempts();
    }
    return outcome.Intersections;
  }

  // Splits all inner edges that join two boundary vertices, and returns whether there was one.
  // Afterwards there is a loop of inner vertices around every handle.
  bool splitChords()
  {
    const int halfedges = this->Surface.halfedgeCount();
    bool any = false;
    for (int h = 0; h < halfedges; ++h)
    {
      if (h < this->Surface.twin(h) && this->Surface.onBoundary(this->Surface.source(h)) &&
          this->Surface.onBoundary(this->Surface.target(h)))
      {
        this->Surface.splitEdge(h);
        this->Labels.followSplit(this->Surface, h);
        any = true;
      }
    }
    return any;
  }

  HalfedgeSurface& Surface;
  const CutAlong& TryCut;
  ProgressCallback Progress;
  double EdgeLength;
  HomologyLabels Labels;
  ShortLoops Loops;
  int HandlesAtStart;
  int HandlesLabelled;
  std::vector<double> Lengths;
  Queue Found; // loops of this search that were not tried yet
  RejectedLoops Rejected;
  std::map<std::uint64_t, ClassAttempts> Attempts;     // per class of rejected loops
  std::set<std::uint64_t> Known;                       // classes that are not searched for any more
  std::map<int, std::set<std::uint64_t>> RejectedFrom; // per seed of this search: rejected classes
};

} // namespace

std::vector<double> cutHandles(HalfedgeSurface& surface,
  const CutAlong& cutAlong,
  const ProgressCallback& progress)
{
  return HandleCutter(surface, cutAlong, progress).run();
}

} // namespace flattening
