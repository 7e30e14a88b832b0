// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/StarKernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{

// The points x with Inward . x >= Distance.
struct HalfPlane
{
  Eigen::Vector2d Inward; // of length 1
  double Distance;

  double excess(const Eigen::Vector2d& x) const { return this->Inward.dot(x) - this->Distance; }
};

// On the border of the last of the half-planes, the point nearest to the origin within the ones before.
std::optional<Eigen::Vector2d> nearestOnBorder(const HalfPlane* first, const HalfPlane* last)
{
  const Eigen::Vector2d foot = last->Distance * last->Inward;
  const Eigen::Vector2d along(-last->Inward.y(), last->Inward.x());
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  for (; first != last; ++first)
  {
    const double rate = first->Inward.dot(along);
    const double crossing = -first->excess(foot) / rate;
    if (rate > 0.0)
    {
      lowest = std::max(lowest, crossing);
    }
    else if (rate < 0.0)
    {
      highest = std::min(highest, crossing);
    }
    else if (first->excess(foot) < 0.0)
    {
      return std::nullopt;
    }
  }
  if (!(lowest <= highest))
  {
    return std::nullopt;
  }
  return foot + std::clamp(0.0, lowest, highest) * along;
}

} // namespace

std::optional<Eigen::Vector2d> nearestInKernel(const Eigen::Vector2d& position,
  const std::vector<OppositeSide>& sides)
{
  std::vector<HalfPlane> halfPlanes;
  for (const OppositeSide& side : sides)
  {
    const Eigen::Vector2d along = side.Second - side.First;
    const Eigen::Vector2d inward = Eigen::Vector2d(-along.y(), along.x()) / along.norm();
    if (!inward.allFinite())
    {
      return std::nullopt;
    }
    halfPlanes.push_back({ inward, inward.dot(side.First - position) + side.Altitude });
  }
  // One half-plane after the other: where the nearest point so far is outside of the next, the new one
  // is on its border.
  Eigen::Vector2d nearest = Eigen::Vector2d::Zero();
  for (const HalfPlane& next : halfPlanes)
  {
    if (next.excess(nearest) < 0.0)
    {
      const std::optional<Eigen::Vector2d> onBorder = nearestOnBorder(halfPlanes.data(), &next);
      if (!onBorder)
      {
        return std::nullopt;
      }
      nearest = *onBorder;
    }
  }
  return position + nearest;
}

} // namespace flattening
