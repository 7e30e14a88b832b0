// SPDX-License-Identifier: GPL-3.0-or-later
#include "RefusedLoops.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace flattening
{
namespace
{

constexpr double Patience = 1.5;
constexpr int Few = 32; // pairs; smoothing takes them apart

} // namespace

double RefusedLoops::Refused::longestInstead() const
{
  return (this->Intersections > Few ? Patience : 1.0) * this->Loop.Length;
}

void RefusedLoops::add(SurfaceLoop loop, int intersections)
{
  this->All.push_back({ std::move(loop), intersections });
}

bool RefusedLoops::contains(const SurfaceLoop& loop) const
{
  return std::any_of(this->All.begin(),
    this->All.end(),
    [&loop](const Refused& refused) { return refused.Loop.Halfedges == loop.Halfedges; });
}

void RefusedLoops::keepIf(const std::function<bool(const SurfaceLoop&)>& stillCuttable)
{
  this->All.erase(std::remove_if(this->All.begin(),
                    this->All.end(),
                    [&stillCuttable](const Refused& refused) { return !stillCuttable(refused.Loop); }),
    this->All.end());
}

const SurfaceLoop* RefusedLoops::due(double length) const
{
  const auto overdue = std::min_element(this->All.begin(),
    this->All.end(),
    [](const Refused& a, const Refused& b) { return a.longestInstead() < b.longestInstead(); });
  if (overdue == this->All.end() || overdue->longestInstead() > length)
  {
    return nullptr;
  }
  const auto best = std::min_element(this->All.begin(),
    this->All.end(),
    [longest = overdue->longestInstead()](const Refused& a, const Refused& b)
    {
      return std::make_tuple(a.Loop.Length > longest, a.Intersections, a.Loop.Length) <
             std::make_tuple(b.Loop.Length > longest, b.Intersections, b.Loop.Length);
    });
  return &best->Loop;
}

} // namespace flattening
