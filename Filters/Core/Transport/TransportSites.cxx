// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/TransportSites.h"

#include "Base/EigenVersions.h"
#include "Mesh/RecursiveBisection.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
namespace
{

// The greatest difference between the logarithms of the scales of vertices that share a site. Between
// sites, the map is interpolated as if the transport stretched all of a group alike; in narrow
// protrusions, where the scale falls by orders of magnitude within a group, that flips thousands of
// faces. A compromise: with 1.5, not all of these faces could be untangled on the skin of a head of half
// a million points; with 0.5, maps of brains took a tenth longer.
constexpr double GreatestScaleRange = 1.0;

// The least extent of a group that is divided, in units of the flat map. A guard: closer positions have
// few digits in doubles. With a site at each of them, the transport did not converge on the skin of a
// head whose nearest points are 1e-15 apart in the conformal map.
constexpr double LeastExtent = 1e-12;

double extentOf(const Points2& points)
{
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

// The groups, and one by one the points of those whose scales differ too much.
std::vector<std::vector<int>> withSimilarScales(const std::vector<std::vector<int>>& groups,
  const Points2& points,
  const Eigen::VectorXd& logScales)
{
  std::vector<std::vector<int>> result;
  result.reserve(groups.size());
  for (const std::vector<int>& group : groups)
  {
    const Eigen::VectorXd scales = logScales(group);
    if (scales.maxCoeff() - scales.minCoeff() <= GreatestScaleRange ||
        extentOf(points(group, flattening::all)) < LeastExtent)
    {
      result.push_back(group);
      continue;
    }
    for (const int i : group)
    {
      result.push_back({ i });
    }
  }
  return result;
}

} // namespace

Eigen::VectorXd TransportSites::sums(const Eigen::VectorXd& values) const
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(this->count());
  for (std::size_t v = 0; v < this->SiteOfVertex.size(); ++v)
  {
    result[this->SiteOfVertex[v]] += values[static_cast<Eigen::Index>(v)];
  }
  return result;
}

TransportSites distinctSites(const Points2& positions)
{
  const int n = static_cast<int>(positions.rows());
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  const auto before = [&positions](int a, int b)
  {
    return positions(a, 0) != positions(b, 0) ? positions(a, 0) < positions(b, 0)
                                              : positions(a, 1) < positions(b, 1);
  };
  std::stable_sort(order.begin(), order.end(), before);
  std::vector<int> representative(n);
  for (int k = 0; k < n; ++k)
  {
    const bool same = k > 0 && !before(order[k - 1], order[k]);
    representative[order[k]] = same ? representative[order[k - 1]] : order[k];
  }
  TransportSites sites;
  sites.SiteOfVertex.resize(n);
  sites.Positions.resize(n, 2);
  int count = 0;
  // The representative is the lowest vertex at its position, since the sort is stable.
  for (int v = 0; v < n; ++v)
  {
    if (representative[v] == v)
    {
      sites.Positions.row(count) = positions.row(v);
      sites.SiteOfVertex[v] = count++;
    }
    else
    {
      sites.SiteOfVertex[v] = sites.SiteOfVertex[representative[v]];
    }
  }
  sites.Positions.conservativeResize(count, 2);
  return sites;
}

TransportSites groupedSites(const Points2& positions,
  const Eigen::VectorXd& masses,
  const Eigen::VectorXd& logScales,
  const std::vector<int>& alone,
  int verticesPerSite)
{
  const int n = static_cast<int>(positions.rows());
  std::vector<char> isAlone(n, 0);
  for (const int v : alone)
  {
    isAlone[v] = 1;
  }
  std::vector<int> grouped;
  for (int v = 0; v < n; ++v)
  {
    if (!isAlone[v])
    {
      grouped.push_back(v);
    }
  }
  const Points2 points = positions(grouped, flattening::all);
  const std::vector<std::vector<int>> groups =
    withSimilarScales(recursiveBisection(points, verticesPerSite, 0.0), points, logScales(grouped));

  Points2 centres(static_cast<Eigen::Index>(groups.size() + alone.size()), 2);
  std::vector<int> groupOf(n);
  int count = 0;
  for (const std::vector<int>& group : groups)
  {
    Eigen::RowVector2d moment = Eigen::RowVector2d::Zero();
    double mass = 0.0;
    for (const int i : group)
    {
      moment += masses[grouped[i]] * points.row(i);
      mass += masses[grouped[i]];
      groupOf[grouped[i]] = count;
    }
    centres.row(count++) = moment / mass;
  }
  for (const int v : alone)
  {
    centres.row(count) = positions.row(v);
    groupOf[v] = count++;
  }
  TransportSites sites = distinctSites(centres);
  std::vector<int> siteOfVertex(n);
  for (int v = 0; v < n; ++v)
  {
    siteOfVertex[v] = sites.SiteOfVertex[groupOf[v]];
  }
  sites.SiteOfVertex = std::move(siteOfVertex);
  return sites;
}

} // namespace flattening
