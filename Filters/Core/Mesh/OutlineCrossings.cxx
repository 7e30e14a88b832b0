// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/OutlineCrossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

namespace flattening
{
namespace
{

using FlatKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using FlatPoint = FlatKernel::Point_2;
using EdgeBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const FlatEdge*>;

// Whether the edges from @p shared to @p a and to @p b have more than that point in common.
bool overlap(const FlatPoint& shared, const FlatPoint& a, const FlatPoint& b)
{
  return CGAL::orientation(shared, a, b) == CGAL::COLLINEAR && CGAL::angle(a, shared, b) != CGAL::OBTUSE;
}

} // namespace

bool edgesCross(const Points2& positions, const std::vector<FlatEdge>& edges)
{
  const auto at = [&](int vertex) { return FlatPoint(positions(vertex, 0), positions(vertex, 1)); };
  std::vector<EdgeBox> boxes;
  boxes.reserve(edges.size());
  for (const FlatEdge& edge : edges)
  {
    const CGAL::Bbox_2 box = at(edge[0]).bbox() + at(edge[1]).bbox();
    boxes.emplace_back(box, &edge);
  }
  bool found = false;
  CGAL::box_self_intersection_d(boxes.begin(),
    boxes.end(),
    [&](const EdgeBox& first, const EdgeBox& second)
    {
      const FlatEdge& a = *first.handle();
      const FlatEdge& b = *second.handle();
      for (int i = 0; i < 2 && !found; ++i)
      {
        for (int j = 0; j < 2; ++j)
        {
          if (a[i] == b[j])
          {
            found = overlap(at(a[i]), at(a[1 - i]), at(b[1 - j]));
            return;
          }
        }
      }
      found = found || CGAL::do_intersect(FlatKernel::Segment_2(at(a[0]), at(a[1])),
                         FlatKernel::Segment_2(at(b[0]), at(b[1])));
    });
  return found;
}

bool isSimpleOutline(const Points2& positions, const std::vector<int>& loop)
{
  std::vector<FlatEdge> edges;
  edges.reserve(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    edges.push_back({ loop[k], loop[(k + 1) % loop.size()] });
  }
  return !edgesCross(positions, edges);
}

} // namespace flattening
