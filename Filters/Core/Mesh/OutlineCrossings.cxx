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

FlatPoint pointAt(const Points2& positions, int vertex)
{
  return { positions(vertex, 0), positions(vertex, 1) };
}

// Whether two edges have a point in common beside the vertex that they share.
bool haveCrossing(const Points2& positions, const FlatEdge& a, const FlatEdge& b)
{
  const auto at = [&](int vertex) { return pointAt(positions, vertex); };
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      if (a[i] == b[j])
      {
        return overlap(at(a[i]), at(a[1 - i]), at(b[1 - j]));
      }
    }
  }
  return CGAL::do_intersect(
    FlatKernel::Segment_2(at(a[0]), at(a[1])), FlatKernel::Segment_2(at(b[0]), at(b[1])));
}

// Calls @p visit with every two of the edges whose boxes have a point in common.
template <typename Visitor>
void forPairsOfNearEdges(const Points2& positions, const std::vector<FlatEdge>& edges, Visitor visit)
{
  std::vector<EdgeBox> boxes;
  boxes.reserve(edges.size());
  for (const FlatEdge& edge : edges)
  {
    const CGAL::Bbox_2 box = pointAt(positions, edge[0]).bbox() + pointAt(positions, edge[1]).bbox();
    boxes.emplace_back(box, &edge);
  }
  CGAL::box_self_intersection_d(boxes.begin(),
    boxes.end(),
    [&](const EdgeBox& first, const EdgeBox& second) { visit(*first.handle(), *second.handle()); });
}

} // namespace

std::vector<FlatEdge> outlineEdges(const std::vector<int>& loop)
{
  std::vector<FlatEdge> edges;
  edges.reserve(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    edges.push_back({ loop[k], loop[(k + 1) % loop.size()] });
  }
  return edges;
}

bool edgesCross(const Points2& positions, const std::vector<FlatEdge>& edges)
{
  bool found = false;
  forPairsOfNearEdges(positions,
    edges,
    [&](const FlatEdge& a, const FlatEdge& b) { found = found || haveCrossing(positions, a, b); });
  return found;
}

std::vector<char> crossingEdges(const Points2& positions, const std::vector<FlatEdge>& edges)
{
  std::vector<char> flags(edges.size(), 0);
  forPairsOfNearEdges(positions,
    edges,
    [&](const FlatEdge& a, const FlatEdge& b)
    {
      if (haveCrossing(positions, a, b))
      {
        flags[&a - edges.data()] = 1;
        flags[&b - edges.data()] = 1;
      }
    });
  return flags;
}

bool isSimpleOutline(const Points2& positions, const std::vector<int>& loop)
{
  return !edgesCross(positions, outlineEdges(loop));
}

} // namespace flattening
