// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/LoopSearch.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace flattening
{

LoopSearch::Result LoopSearch::shortestFrom(int seed,
  double walk,
  double near,
  const std::set<std::uint64_t>& ignored)
{
  const HalfedgeSurface& surface = this->Surface;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const int search = ++this->Searches;
  const int settled = -search;
  this->Vertices.resize(surface.vertexCount(), { 0.0, 0, -1, 0 });
  this->Vertices[seed] = { 0.0, 0, -1, search };
  queue.emplace(0.0, seed);
  Result result;
  double best = walk;
  int closing = -1;
  while (!queue.empty())
  {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (2.0 * distance > best) // not when it was put there, maybe
    {
      break;
    }
    Reached& here = this->Vertices[v];
    if (here.Search == settled)
    {
      continue;
    }
    here.Search = settled;
    if (distance <= near)
    {
      result.Near.push_back(v);
    }
    const int first = surface.outgoing(v);
    int h = first;
    do
    {
      const int w = surface.tip(h);
      const std::uint64_t hash = here.Hash ^ this->Labels.hash(h);
      Reached& next = this->Vertices[w];
      if (next.Search == settled)
      {
        if (next.Hash != hash && !ignored.count(next.Hash ^ hash))
        {
          const double there = distance + surface.length(h);
          if (there + next.Distance < best)
          {
            best = there + next.Distance;
            closing = h;
          }
          result.WasBounded = true;
        }
      }
      else if (const double there = distance + surface.length(h);
               next.Search != search || there < next.Distance)
      {
        if (2.0 * there > best)
        {
          result.WasBounded = true;
        }
        else if (!surface.onBoundary(w))
        {
          next = { there, hash, h, search };
          queue.emplace(there, w);
        }
      }
      h = surface.rotated(h);
    } while (h != first);
  }
  if (closing >= 0)
  {
    result.Loop = this->loopThrough(closing, seed);
    result.WasBounded = false;
  }
  return result;
}

SurfaceLoop LoopSearch::loopThrough(int closing, int seed) const
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

} // namespace flattening
