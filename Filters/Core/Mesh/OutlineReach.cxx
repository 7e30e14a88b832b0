// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/OutlineReach.h"

#include <Eigen/Geometry>

#include <CGAL/Bbox_2.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <initializer_list>

namespace flattening
{
namespace
{

// The part of a distance that each of two edges may use up. Less than a half, because rounding must not
// decide.
constexpr double RoomShare = 0.49;

using ReachBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const int*>;

double distanceToEdge(const Eigen::Vector2d& point,
  const Eigen::Vector2d& from,
  const Eigen::Vector2d& to)
{
  const Eigen::Vector2d edge = to - from;
  const double length2 = edge.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((point - from).dot(edge) / length2, 0.0, 1.0) : 0.0;
  return (from + share * edge - point).norm();
}

} // namespace

std::vector<double> outlineReach(const Points2& positions,
  const std::vector<int>& loop,
  const std::vector<int>& groups)
{
  const int count = static_cast<int>(loop.size());
  const auto at = [&](int member) -> Eigen::Vector2d { return positions.row(loop[member % count]); };
  const auto areTogether = [&](int i, int j) { return groups[i] >= 0 && groups[i] == groups[j]; };
  const auto lower = [](double& value, double bound) { value = std::min(value, bound); };
  std::vector<double> room(count); // of the vertices
  std::vector<double> lengths(count);
  for (int k = 0; k < count; ++k)
  {
    lengths[k] = (at(k + 1) - at(k)).norm();
  }
  for (int k = 0; k < count; ++k)
  {
    room[k] = std::max(lengths[k], lengths[(k + count - 1) % count]);
  }
  const auto lowerAll = [&](std::initializer_list<int> members, double bound)
  {
    for (const int member : members)
    {
      lower(room[member % count], bound);
    }
  };
  for (int k = 0; k < count; ++k)
  {
    const int next = (k + 1) % count;
    if (!areTogether(k, next))
    {
      const int last = (k + 2) % count;
      lowerAll({ k, next, last },
        std::min(distanceToEdge(at(k), at(next), at(last)), distanceToEdge(at(last), at(k), at(next))));
    }
  }
  // Boxes that are apart belong to edges whose distance is at least the sum of half the rooms.
  std::vector<int> numbers(count);
  std::vector<ReachBox> boxes;
  for (int k = 0; k < count; ++k)
  {
    numbers[k] = k;
    const Eigen::Vector2d half =
      Eigen::Vector2d::Constant(0.5 * std::max(room[k], room[(k + 1) % count]));
    const Eigen::Vector2d low = at(k).cwiseMin(at(k + 1)) - half;
    const Eigen::Vector2d high = at(k).cwiseMax(at(k + 1)) + half;
    const CGAL::Bbox_2 box(low.x(), low.y(), high.x(), high.y());
    boxes.emplace_back(box, &numbers[k]);
  }
  CGAL::box_self_intersection_d(boxes.begin(),
    boxes.end(),
    [&](const ReachBox& a, const ReachBox& b)
    {
      const int i = *a.handle();
      const int j = *b.handle();
      if ((i + 1) % count == j || (j + 1) % count == i || areTogether(i, j))
      {
        return;
      }
      lowerAll({ i, i + 1, j, j + 1 },
        std::min({ distanceToEdge(at(i), at(j), at(j + 1)),
          distanceToEdge(at(i + 1), at(j), at(j + 1)),
          distanceToEdge(at(j), at(i), at(i + 1)),
          distanceToEdge(at(j + 1), at(i), at(i + 1)) }));
    });
  for (double& distance : room)
  {
    distance *= RoomShare;
  }
  return room;
}

} // namespace flattening
