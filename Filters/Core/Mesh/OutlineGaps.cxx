// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/OutlineGaps.h"

#include "Mesh/OutlineTriangulation.h"

#include <map>
#include <utility>

namespace flattening
{
namespace
{

constexpr double CosineOfShallow = -0.5; // of 120 degrees

} // namespace

FaceMatrix outlineGaps(const Points2& positions, const std::vector<FlatEdge>& edges)
{
  return OutlineTriangulation(positions, edges).outside();
}

FaceMatrix withoutShallowBays(const FaceMatrix& gaps,
  const Points2& positions,
  const std::vector<FlatEdge>& edges)
{
  std::map<FlatEdge, Eigen::Index> gapAt; // by its directed sides
  for (Eigen::Index gap = 0; gap < gaps.rows(); ++gap)
  {
    for (int k = 0; k < 3; ++k)
    {
      gapAt[{ gaps(gap, k), gaps(gap, (k + 1) % 3) }] = gap;
    }
  }
  // The polygon that is left when bays are filled.
  std::vector<int> next(positions.rows(), -1);
  std::vector<int> previous(positions.rows(), -1);
  std::vector<int> waiting;
  for (const auto& [from, to] : edges)
  {
    next[from] = to;
    previous[to] = from;
    waiting.push_back(from);
  }
  std::vector<char> isFilled(gaps.rows(), 0);
  while (!waiting.empty())
  {
    const int v = waiting.back();
    waiting.pop_back();
    const int before = previous[v];
    const int after = next[v];
    const auto gap = gapAt.find({ v, before });
    const auto same = gapAt.find({ after, v });
    if (gap == gapAt.end() || same == gapAt.end() || gap->second != same->second ||
        isFilled[gap->second])
    {
      continue;
    }
    const Eigen::Vector2d back = positions.row(before) - positions.row(v);
    const Eigen::Vector2d on = positions.row(after) - positions.row(v);
    if (back.dot(on) < CosineOfShallow * back.norm() * on.norm())
    {
      isFilled[gap->second] = 1;
      next[before] = after;
      previous[after] = before;
      waiting.push_back(before);
      waiting.push_back(after);
    }
  }
  FaceMatrix left(gaps.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index gap = 0; gap < gaps.rows(); ++gap)
  {
    if (!isFilled[gap])
    {
      left.row(count++) = gaps.row(gap);
    }
  }
  left.conservativeResize(count, 3);
  return left;
}

} // namespace flattening
