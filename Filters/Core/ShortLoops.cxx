// SPDX-License-Identifier: GPL-3.0-or-later
#include "ShortLoops.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace flattening
{

std::vector<int> ShortLoops::seeds() const
{
  std::vector<int> result;
  for (int h = 0; h < this->Surface.halfedgeCount(); ++h)
  {
    if (h > this->Surface.twin(h) && this->Labels.hash(h) != 0)
    {
      result.push_back(this->Surface.origin(h));
    }
  }
  return result;
}

std::vector<SurfaceLoop> ShortLoops::find(const std::vector<int>& seeds,
  double length,
  const ProgressCallback& progress)
{
  constexpr std::size_t ReportInterval = 256;
  this->Bounded = false;
  ++this->Finds;
  this->Covered.resize(this->Surface.vertexCount(), 0);
  this->Length = length;
  std::vector<SurfaceLoop> loops;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    if (i % ReportInterval == 0)
    {
      report(progress, static_cast<double>(i) / seeds.size(), "searching for handles");
    }
    if (this->Covered[seeds[i]] == this->Finds)
    {
      continue;
    }
    SurfaceLoop loop = this->findAgain(seeds[i]);
    if (!loop.Halfedges.empty())
    {
      loops.push_back(std::move(loop));
    }
  }
  std::sort(loops.begin(),
    loops.end(),
    [](const SurfaceLoop& a, const SurfaceLoop& b)
    { return a.Length != b.Length ? a.Length < b.Length : a.Seed < b.Seed; });
  return loops;
}

SurfaceLoop ShortLoops::findAgain(int seed)
{
  if (this->Surface.onBoundary(seed))
  {
    return {};
  }
  // From a seed within `near` of a loop, the walk there, around, and back.
  const double near = 0.5 * this->Length;
  return this->shortestFrom(seed, this->Length + 2.0 * near, near);
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

SurfaceLoop ShortLoops::shortestFrom(int seed, double walk, double near)
{
  const HalfedgeSurface& surface = this->Surface;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const int search = ++this->Searches;
  this->Vertices.resize(surface.vertexCount(), { 0.0, 0, -1, 0, false });
  this->Covered.resize(surface.vertexCount(), 0);
  this->Vertices[seed] = { 0.0, 0, -1, search, false };
  queue.emplace(0.0, seed);
  double best = walk;
  int closing = -1;
  while (!queue.empty())
  {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (2.0 * distance > best)
    {
      this->Bounded = this->Bounded || closing < 0;
      break;
    }
    Reached& here = this->Vertices[v];
    if (here.Settled)
    {
      continue;
    }
    here.Settled = true;
    if (distance <= near)
    {
      this->Covered[v] = this->Finds;
    }
    const int first = surface.outgoing(v);
    int h = first;
    do
    {
      const int w = surface.tip(h);
      const double there = distance + surface.length(h);
      const std::uint64_t hash = here.Hash ^ this->Labels.hash(h);
      Reached& next = this->Vertices[w];
      if (next.Search == search && next.Settled)
      {
        if (next.Hash != hash && there + next.Distance < best && !this->Ignored.count(next.Hash ^ hash))
        {
          best = there + next.Distance;
          closing = h;
        }
      }
      else if ((next.Search != search || there < next.Distance) && !surface.onBoundary(w))
      {
        next = { there, hash, h, search, false };
        queue.emplace(there, w);
      }
      h = surface.rotated(h);
    } while (h != first);
  }
  return closing < 0 ? SurfaceLoop{} : this->loopThrough(closing, seed);
}

SurfaceLoop ShortLoops::loopThrough(int closing, int seed) const
{
  const auto pathTo = [this](int v)
  {
    std::vector<int> path;
    for (int h = this->Vertices[v].Edge; h >= 0; h = this->Vertices[this->Surface.origin(h)].Edge)
    {
      path.push_back(h);
    }
    std::reverse(path.begin(), path.end());
    return path;
  };
  const std::vector<int> out = pathTo(this->Surface.origin(closing));
  const std::vector<int> back = pathTo(this->Surface.tip(closing));
  std::size_t common = 0;
  while (common < out.size() && common < back.size() && out[common] == back[common])
  {
    ++common;
  }
  SurfaceLoop loop;
  loop.Seed = seed;
  loop.Halfedges.assign(out.begin() + static_cast<std::ptrdiff_t>(common), out.end());
  loop.Halfedges.push_back(closing);
  for (std::size_t i = back.size(); i-- > common;)
  {
    loop.Halfedges.push_back(this->Surface.twin(back[i]));
  }
  for (const int h : loop.Halfedges)
  {
    loop.Length += this->Surface.length(h);
  }
  return loop;
}

void ShortLoops::tighten(SurfaceLoop& loop)
{
  constexpr int Places = 4;
  constexpr double Gain = 1.0 - 1e-9;
  bool shorter = true;
  while (shorter)
  {
    shorter = false;
    for (int i = 0; i < Places && !shorter; ++i)
    {
      const int v = this->Surface.origin(loop.Halfedges[i * loop.Halfedges.size() / Places]);
      SurfaceLoop other = this->shortestFrom(v, Gain * loop.Length, -1.0);
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
