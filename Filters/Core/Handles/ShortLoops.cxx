// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/ShortLoops.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{

// Each thread keeps a search with 24 bytes per vertex. The number is a guard against more memory than
// the surface itself takes; it changes no result.
constexpr int MostThreads = 8;

// Seeds within this share of a length from another seed are not searched from: a loop of that length
// through them is part of a walk from the other seed, there, around and back, of 1 + 2 NearShare
// lengths. Derived: with 1/2 that walk, and so the loop found, is at most twice as long. A smaller share
// makes more searches, a larger one longer ones.
constexpr double NearShare = 0.5;

// Searches that are started together. Only those that the result of an earlier one in the batch makes
// needless are lost; the size adapts to that. A guard for memory that changes no result.
constexpr std::size_t SmallestBatch = 2;
constexpr std::size_t LargestBatch = 256;

// Orders seeds so that consecutive ones are far from each other, though neighbours in the list are near
// to each other: by steps of the golden section.
std::vector<int> spread(const std::vector<int>& seeds)
{
  const std::size_t n = seeds.size();
  constexpr double GoldenSection = 0.6180339887498949;
  auto step = std::max<std::size_t>(1, static_cast<std::size_t>(GoldenSection * n));
  while (std::gcd(step, n) > 1)
  {
    ++step;
  }
  std::vector<int> result;
  result.reserve(n);
  for (std::size_t i = 0, at = 0; i < n; ++i, at = (at + step) % n)
  {
    result.push_back(seeds[at]);
  }
  return result;
}

} // namespace

ShortLoops::ShortLoops(const HalfedgeSurface& surface, const HomologyLabels& labels)
  : Surface(surface)
  , Labels(labels)
  , Searches([&surface, &labels] { return LoopSearch(surface, labels); })
{
}

std::vector<int> ShortLoops::seeds() const
{
  std::vector<int> result;
  for (int h = 0; h < this->Surface.halfedgeCount(); ++h)
  {
    if (h > this->Surface.twin(h) && this->Labels.hash(h) != 0)
    {
      result.push_back(this->Surface.source(h));
    }
  }
  return result;
}

std::vector<SurfaceLoop> ShortLoops::find(const std::vector<int>& seeds,
  double length,
  const ProgressCallback& progress)
{
  this->Bounded = false;
  this->Length = length;
  const std::vector<int> order = spread(seeds);
  std::vector<char> covered(this->Surface.vertexCount(), 0);
  std::vector<SurfaceLoop> loops;
  std::size_t next = 0;
  std::size_t batchSize = SmallestBatch;
  while (next < order.size())
  {
    report(progress, static_cast<double>(next) / order.size(), "searching for handles");
    std::vector<int> batch;
    for (; next < order.size() && batch.size() < batchSize; ++next)
    {
      if (!covered[order[next]])
      {
        batch.push_back(order[next]);
      }
    }
    std::vector<LoopSearch::Result> results =
      this->searchAll(batch, (1.0 + 2.0 * NearShare) * length, NearShare * length);
    // The result is that of a single thread, which would not have searched from a covered seed.
    std::size_t wasted = 0;
    for (std::size_t i = 0; i < batch.size(); ++i)
    {
      if (covered[batch[i]])
      {
        ++wasted;
        continue;
      }
      for (const int v : results[i].Near)
      {
        covered[v] = 1;
      }
      this->Bounded = this->Bounded || results[i].WasBounded;
      if (!results[i].Loop.Halfedges.empty())
      {
        loops.push_back(std::move(results[i].Loop));
      }
    }
    batchSize =
      wasted == 0 ? std::min(LargestBatch, 2 * batchSize) : std::max(SmallestBatch, batchSize / 2);
  }
  std::sort(loops.begin(),
    loops.end(),
    [](const SurfaceLoop& a, const SurfaceLoop& b)
    { return a.Length != b.Length ? a.Length < b.Length : a.Seed < b.Seed; });
  return loops;
}

SurfaceLoop ShortLoops::findAgain(int seed, double length)
{
  LoopSearch::Result result =
    this->search(seed, std::min(length, this->Length) + 2.0 * NearShare * this->Length, -1.0);
  this->Bounded = this->Bounded || result.WasBounded;
  return std::move(result.Loop);
}

std::vector<SurfaceLoop> ShortLoops::findBeside(const SurfaceLoop& loop, double length)
{
  std::vector<SurfaceLoop> loops;
  for (LoopSearch::Result& result : this->searchAll(this->verticesBeside(loop), length, -1.0))
  {
    if (!result.Loop.Halfedges.empty())
    {
      result.Loop.Seed = -1;
      loops.push_back(std::move(result.Loop));
    }
  }
  return loops;
}

// Ten vertices that are up to half as many edges away as the loop has, more near to it than far.
std::vector<int> ShortLoops::verticesBeside(const SurfaceLoop& loop) const
{
  constexpr std::size_t Chosen = 10; // a convention; each costs a search
  std::set<int> reached;
  std::vector<int> order;
  const auto reach = [&](int v)
  {
    if (reached.insert(v).second)
    {
      order.push_back(v);
    }
  };
  for (const int h : loop.Halfedges)
  {
    reach(this->Surface.source(h));
  }
  std::size_t begin = 0;
  for (std::size_t ring = 0; ring < 1 + loop.Halfedges.size() / 2; ++ring)
  {
    const std::size_t end = order.size();
    for (; begin < end; ++begin)
    {
      if (!this->Surface.onBoundary(order[begin]))
      {
        this->Surface.visitOutgoing(order[begin], [&](int h) { reach(this->Surface.target(h)); });
      }
    }
  }
  const std::size_t n = loop.Halfedges.size();
  std::vector<int> result;
  for (std::size_t i = 1; i <= Chosen && order.size() > n; ++i)
  {
    result.push_back(order[n - 1 + i * i * (order.size() - n) / (Chosen * Chosen)]);
  }
  return result;
}

std::vector<LoopSearch::Result> ShortLoops::searchAll(const std::vector<int>& seeds,
  double walk,
  double near)
{
  std::vector<LoopSearch::Result> results(seeds.size());
  tbb::task_arena arena(std::min(MostThreads, tbb::this_task_arena::max_concurrency()));
  arena.execute(
    [&]
    {
      tbb::parallel_for(std::size_t(0),
        seeds.size(),
        [&](std::size_t i) { results[i] = this->search(seeds[i], walk, near); });
    });
  return results;
}

LoopSearch::Result ShortLoops::search(int seed, double walk, double near)
{
  return this->Surface.onBoundary(seed)
           ? LoopSearch::Result{}
           : this->Searches.local().shortestFrom(seed, walk, near, this->Ignored);
}

std::uint64_t ShortLoops::classHash(const SurfaceLoop& loop) const
{
  std::uint64_t hash = 0;
  for (const int h : loop.Halfedges)
  {
    hash ^= this->Labels.hash(h);
  }
  return hash;
}

void ShortLoops::tighten(SurfaceLoop& loop)
{
  constexpr int Places = 4;           // vertices of the loop to search from; a convention
  constexpr double Gain = 1.0 - 1e-9; // a guard against endless exchange of equal loops by rounding
  bool shorter = true;
  while (shorter)
  {
    shorter = false;
    for (int i = 0; i < Places && !shorter; ++i)
    {
      const int v = this->Surface.source(loop.Halfedges[i * loop.Halfedges.size() / Places]);
      SurfaceLoop other = this->search(v, Gain * loop.Length, -1.0).Loop;
      if (!other.Halfedges.empty() && other.Length < Gain * loop.Length)
      {
        other.Seed = loop.Seed;
        loop = std::move(other);
        shorter = true;
      }
    }
  }
}

} // namespace flattening
