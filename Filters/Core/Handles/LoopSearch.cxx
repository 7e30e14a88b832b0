// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/LoopSearch.h"

#include <algorithm>

namespace flattening
{

LoopSearch::Result LoopSearch::shortestFrom(int seed,
  double walk,
  double near,
  const std::set<std::uint64_t>& ignored)
{
  this->Vertices.resize(this->Surface.vertexCount(), { 0.0, 0, -1, 0 });
  ++this->Searches;
  this->Queue = {};
  this->ShortestWalk = walk;
  this->Closing = -1;
  this->WasBounded = false;
  this->reach(seed, { 0.0, 0, -1, this->Searches });
  Result result;
  while (!this->Queue.empty() && 2.0 * this->Queue.top().first <= this->ShortestWalk)
  {
    const auto [distance, v] = this->Queue.top();
    this->Queue.pop();
    if (this->isSettled(v))
    {
      continue;
    }
    this->Vertices[v].Search = -this->Searches;
    if (distance <= near)
    {
      result.Near.push_back(v);
    }
    this->Surface.visitOutgoing(v, [&](int h) { this->follow(h, ignored); });
  }
  if (this->Closing >= 0)
  {
    result.Loop = this->closedLoop(seed);
  }
  result.WasBounded = this->WasBounded && this->Closing < 0;
  return result;
}

void LoopSearch::reach(int v, const Reached& how)
{
  this->Vertices[v] = how;
  this->Queue.emplace(how.Distance, v);
}

// Takes the search over a half-edge that leaves a settled vertex.
void LoopSearch::follow(int h, const std::set<std::uint64_t>& ignored)
{
  const Reached& here = this->Vertices[this->Surface.source(h)];
  const int to = this->Surface.target(h);
  const Reached& there = this->Vertices[to];
  const std::uint64_t hash = here.Hash ^ this->Labels.hash(h);
  if (this->isSettled(to))
  {
    if (there.Hash != hash && !ignored.count(there.Hash ^ hash))
    {
      const double walk = here.Distance + this->Surface.length(h) + there.Distance;
      if (walk < this->ShortestWalk)
      {
        this->ShortestWalk = walk;
        this->Closing = h;
      }
      this->WasBounded = true;
    }
    return;
  }
  const double distance = here.Distance + this->Surface.length(h);
  if (there.Search == this->Searches && distance >= there.Distance)
  {
    return;
  }
  if (2.0 * distance > this->ShortestWalk)
  {
    this->WasBounded = true;
  }
  else if (!this->Surface.onBoundary(to))
  {
    this->reach(to, { distance, hash, h, this->Searches });
  }
}

// Half-edges from the seed.
std::vector<int> LoopSearch::pathTo(int v) const
{
  std::vector<int> path;
  for (int h = this->Vertices[v].Edge; h >= 0; h = this->Vertices[this->Surface.source(h)].Edge)
  {
    path.push_back(h);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

// The shortest walk without the path that its two halves share.
SurfaceLoop LoopSearch::closedLoop(int seed) const
{
  const std::vector<int> out = this->pathTo(this->Surface.source(this->Closing));
  const std::vector<int> back = this->pathTo(this->Surface.target(this->Closing));
  const auto common =
    std::mismatch(out.begin(), out.end(), back.begin(), back.end()).first - out.begin();
  SurfaceLoop loop;
  loop.Seed = seed;
  loop.Halfedges.assign(out.begin() + common, out.end());
  loop.Halfedges.push_back(this->Closing);
  std::for_each(back.rbegin(),
    back.rend() - common,
    [&](int h) { loop.Halfedges.push_back(this->Surface.twin(h)); });
  for (const int h : loop.Halfedges)
  {
    loop.Length += this->Surface.length(h);
  }
  return loop;
}

} // namespace flattening
