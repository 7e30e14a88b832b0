// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryPlacement.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

struct Pool
{
  double Sum;
  int Count;
  double mean() const { return this->Sum / this->Count; }
};

double preferredAngle(const PowerDiagram& diagram, int site)
{
  const PowerDiagram::BoundaryPart arc = diagram.boundaryPart(site);
  const Eigen::RowVector2d centroid = diagram.centroids().row(site);
  return arc.Length > 0.0 ? arc.Middle : std::atan2(centroid.y(), centroid.x());
}

} // namespace

std::vector<double> strictlyIncreasingFit(const std::vector<double>& values)
{
  std::vector<Pool> pools;
  for (const double value : values)
  {
    pools.push_back({ value, 1 });
    while (pools.size() > 1 && pools[pools.size() - 2].mean() >= pools.back().mean())
    {
      pools[pools.size() - 2].Sum += pools.back().Sum;
      pools[pools.size() - 2].Count += pools.back().Count;
      pools.pop_back();
    }
  }
  std::vector<double> fit;
  for (std::size_t p = 0; p < pools.size(); ++p)
  {
    const double mean = pools[p].mean();
    // A third of the smaller gap to either side; with no neighbour at all any width does.
    double width = 1.0;
    width = p > 0 ? std::min(width, mean - pools[p - 1].mean()) : width;
    width = p + 1 < pools.size() ? std::min(width, pools[p + 1].mean() - mean) : width;
    for (int k = 0; k < pools[p].Count; ++k)
    {
      fit.push_back(
        pools[p].Count == 1 ? mean : mean + width / 3.0 * (2.0 * k / (pools[p].Count - 1.0) - 1.0));
    }
  }
  return fit;
}

std::vector<double> boundaryAngles(const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex)
{
  constexpr double turn = 2.0 * EIGEN_PI;
  const int n = static_cast<int>(loop.size());
  std::vector<double> angles(n);
  for (int k = 0; k < n; ++k)
  {
    angles[k] = preferredAngle(diagram, siteOfVertex[loop[k]]);
  }
  // Unroll the circle where the widest gap is, so that the order can break nowhere near the cut.
  int cut = 0;
  double widest = -1.0;
  for (int k = 0; k < n; ++k)
  {
    const double gap = std::remainder(angles[k] - angles[(k + n - 1) % n], turn);
    if (gap > widest)
    {
      widest = gap;
      cut = k;
    }
  }
  std::vector<double> unrolled(n);
  for (int k = 0; k < n; ++k)
  {
    const double angle = angles[(cut + k) % n];
    unrolled[k] = k == 0 ? angle : unrolled[k - 1] + std::remainder(angle - unrolled[k - 1], turn);
  }
  const std::vector<double> fit = strictlyIncreasingFit(unrolled);
  for (int k = 0; k < n; ++k)
  {
    angles[(cut + k) % n] = fit[k];
  }
  for (int k = n - cut; k < n; ++k)
  {
    // Members before the cut follow one turn later: keep the loop increasing from its first vertex.
    angles[(cut + k) % n] -= turn;
  }
  return angles;
}

} // namespace flattening
