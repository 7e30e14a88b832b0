// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/CoincidentPoints.h"

#include "Mesh/EditableSurface.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>

#include <tbb/parallel_sort.h>

#include <iterator>
#include <numeric>
#include <tuple>

namespace flattening
{
namespace
{

// A point, and which one it is.
using NumberedPoint = std::tuple<double, double, double, int>;

bool haveSameCoordinates(const NumberedPoint& a, const NumberedPoint& b)
{
  return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b) &&
         std::get<2>(a) == std::get<2>(b);
}

// For every point the first one with the same coordinates; for one that is not finite itself.
std::vector<int> exactlyCoincident(const Points3& points)
{
  std::vector<int> representative(points.rows());
  std::iota(representative.begin(), representative.end(), 0);
  std::vector<NumberedPoint> sorted;
  sorted.reserve(representative.size());
  for (const int v : representative)
  {
    if (points.row(v).allFinite())
    {
      sorted.emplace_back(points(v, 0), points(v, 1), points(v, 2), v);
    }
  }
  tbb::parallel_sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (haveSameCoordinates(sorted[i], sorted[i - 1]))
    {
      representative[std::get<3>(sorted[i])] = representative[std::get<3>(sorted[i - 1])];
    }
  }
  return representative;
}

} // namespace

std::vector<int> coincidentPoints(const Points3& points, double tolerance)
{
  std::vector<int> representative = exactlyCoincident(points);
  if (!(tolerance > 0.0))
  {
    return representative;
  }

  using Indexed = std::pair<Kernel::Point_3, int>;
  using Traits = CGAL::Search_traits_adapter<Indexed,
    CGAL::First_of_pair_property_map<Indexed>,
    CGAL::Search_traits_3<Kernel>>;
  std::vector<Indexed> distinct;
  for (int v = 0; v < points.rows(); ++v)
  {
    if (representative[v] == v && points.row(v).allFinite())
    {
      distinct.emplace_back(pointOf(points, v), v);
    }
  }
  const CGAL::Kd_tree<Traits> tree(distinct.begin(), distinct.end());

  std::vector<int> joins(points.rows(), -1); // the representative that each one joins
  std::vector<Indexed> near;
  for (const Indexed& point : distinct)
  {
    if (joins[point.second] < 0)
    {
      near.clear();
      tree.search(std::back_inserter(near), CGAL::Fuzzy_sphere<Traits>(point, tolerance));
      for (const Indexed& other : near)
      {
        if (joins[other.second] < 0)
        {
          joins[other.second] = point.second;
        }
      }
    }
  }
  for (int& v : representative)
  {
    v = joins[v] < 0 ? v : joins[v];
  }
  return representative;
}

} // namespace flattening
