// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/RejectedLoops.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace flattening
{
namespace
{

constexpr double Patience = 1.5;

} // namespace

RejectedLoops::RejectedLoops(double longestDetour)
  : LongestDetour(longestDetour)
{
}

double RejectedLoops::longestInstead(const Refused& refused) const
{
  const double length = refused.Loop.Length;
  return refused.Intersections > Few ? std::min(Patience * length, length + this->LongestDetour)
                                     : length;
}

double RejectedLoops::Refused::cost() const
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
    [&loop](const Refused& refused) { return refused.Loop.Halfedges == loop.Halfedges; });
}

void RejectedLoops::keepIf(const std::function<bool(const SurfaceLoop&)>& stillCuttable)
{
  this->All.erase(std::remove_if(this->All.begin(),
                    this->All.end(),
                    [&stillCuttable](const Refused& refused) { return !stillCuttable(refused.Loop); }),
    this->All.end());
}

void RejectedLoops::visit(const std::function<void(const SurfaceLoop&, int intersections)>& visit) const
{
  for (const Refused& refused : this->All)
  {
    visit(refused.Loop, refused.Intersections);
  }
}

double RejectedLoops::shortest() const
{
  const auto shortest = std::min_element(this->All.begin(),
    this->All.end(),
    [](const Refused& a, const Refused& b) { return a.Loop.Length < b.Loop.Length; });
  return shortest == this->All.end() ? 0.0 : shortest->Loop.Length;
}

double RejectedLoops::limit() const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Refused& refused : this->All)
  {
    if (refused.Intersections > Few)
    {
      least = std::min(least, this->longestInstead(refused));
    }
  }
  return least;
}

const SurfaceLoop* RejectedLoops::due(double searched, double tried) const
{
  double longest = std::numeric_limits<double>::infinity();
  for (const Refused& refused : this->All)
  {
    if (refused.Loop.Length <= searched && this->longestInstead(refused) <= tried)
    {
      longest = std::min(longest, this->longestInstead(refused));
    }
  }
  const Refused* best = nullptr;
  for (const Refused& refused : this->All)
  {
    if (refused.Loop.Length <= longest && (!best || refused.cost() < best->cost()))
    {
      best = &refused;
    }
  }
  return longest < std::numeric_limits<double>::infinity() ? &best->Loop : nullptr;
}

} // namespace flattening
