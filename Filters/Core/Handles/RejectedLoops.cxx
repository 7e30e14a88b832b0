// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/RejectedLoops.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{

// How many times as long a loop may be that is cut instead of one through a fold. A convention: with a
// larger factor the cuts are longer and change more of the surface.
constexpr double Patience = 1.5;

} // namespace

RejectedLoops::RejectedLoops(double longestDetour)
  : LongestDetour(longestDetour)
{
}

double RejectedLoops::longestInstead(const Rejected& rejected) const
{
  const double length = rejected.Loop.Length;
  return rejected.Intersections > Few ? std::min(Patience * length, length + this->LongestDetour)
                                      : length;
}

double RejectedLoops::Rejected::cost() const
{
  return this->Intersections * this->Loop.Length;
}

void RejectedLoops::add(SurfaceLoop loop, int intersections)
{
  this->All.push_back({ std::move(loop), intersections });
}

bool RejectedLoops::contains(const SurfaceLoop& loop) const
{
  return std::any_of(this->All.begin(),
    this->All.end(),
    [&loop](const Rejected& rejected) { return rejected.Loop.Halfedges == loop.Halfedges; });
}

void RejectedLoops::keepIf(const std::function<bool(const SurfaceLoop&)>& stillCuttable)
{
  this->All.erase(
    std::remove_if(this->All.begin(),
      this->All.end(),
      [&stillCuttable](const Rejected& rejected) { return !stillCuttable(rejected.Loop); }),
    this->All.end());
}

void RejectedLoops::visit(const std::function<void(const SurfaceLoop&, int intersections)>& visit) const
{
  for (const Rejected& rejected : this->All)
  {
    visit(rejected.Loop, rejected.Intersections);
  }
}

double RejectedLoops::shortest() const
{
  const auto shortest = std::min_element(this->All.begin(),
    this->All.end(),
    [](const Rejected& a, const Rejected& b) { return a.Loop.Length < b.Loop.Length; });
  return shortest == this->All.end() ? 0.0 : shortest->Loop.Length;
}

double RejectedLoops::limit() const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Rejected& rejected : this->All)
  {
    if (rejected.Intersections > Few)
    {
      least = std::min(least, this->longestInstead(rejected));
    }
  }
  return least;
}

const SurfaceLoop* RejectedLoops::due(double searched, double tried) const
{
  double longest = std::numeric_limits<double>::infinity();
  for (const Rejected& rejected : this->All)
  {
    if (rejected.Loop.Length <= searched && this->longestInstead(rejected) <= tried)
    {
      longest = std::min(longest, this->longestInstead(rejected));
    }
  }
  const Rejected* best = nullptr;
  for (const Rejected& rejected : this->All)
  {
    if (rejected.Loop.Length <= longest && (!best || rejected.cost() < best->cost()))
    {
      best = &rejected;
    }
  }
  return longest < std::numeric_limits<double>::infinity() ? &best->Loop : nullptr;
}

} // namespace flattening
