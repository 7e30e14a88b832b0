// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/InitialWeights.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{

// Of area over target: clusters within clusters are opened about places of their own.
constexpr double DenseRatios[] = { 1e-3, 1e-7, 1e-11, 1e-15, 1e-19 };

// Sites with all others further off do not need more than double precision: 1e-16 of a weight is at most
// 1e-10 of the disk for the sides of their cells.
constexpr double CloseDistance = 1e-6;

double distance(const Points2& sites, int site, int otherSite)
{
  return (sites.row(site) - sites.row(otherSite)).norm();
}

DoubleDouble preciseDistance(const Points2& sites, int site, int otherSite)
{
  const DoubleDouble x = DoubleDouble::sum(sites(site, 0), -sites(otherSite, 0));
  const DoubleDouble y = DoubleDouble::sum(sites(site, 1), -sites(otherSite, 1));
  return sqrt(x * x + y * y);
}

// Of every site from the nearest one whose cell has a side in common with its own.
Eigen::VectorXd nearestDistances(const PowerDiagram& diagram)
{
  Eigen::VectorXd nearest =
    Eigen::VectorXd::Constant(diagram.siteCount(), std::numeric_limits<double>::infinity());
  for (const PowerDiagram::CommonSide& side : diagram.commonSides())
  {
    nearest[side.First] = std::min(nearest[side.First], side.Distance);
    nearest[side.Second] = std::min(nearest[side.Second], side.Distance);
  }
  return nearest;
}

// The sites marked in @p dense by connected component of the diagram, components in the order of their
// lowest site.
std::vector<std::vector<int>> connectedSites(const PowerDiagram& diagram, const std::vector<char>& dense)
{
  std::vector<int> root(dense.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int site)
  {
    while (root[site] != site)
    {
      site = root[site] = root[root[site]];
    }
    return site;
  };
  for (const PowerDiagram::CommonSide& side : diagram.commonSides())
  {
    if (dense[side.First] && dense[side.Second])
    {
      const int first = find(side.First);
      const int second = find(side.Second);
      root[std::max(first, second)] = std::min(first, second);
    }
  }
  std::vector<std::vector<int>> components;
  std::vector<int> number(dense.size(), -1);
  for (int i = 0; i < diagram.siteCount(); ++i)
  {
    if (dense[i])
    {
      int& entry = number[find(i)];
      if (entry < 0)
      {
        entry = static_cast<int>(components.size());
        components.emplace_back();
      }
      components[entry].push_back(i);
    }
  }
  return components;
}

// The potential of one cluster. Between two members h' runs linearly, which keeps h strictly convex and
// its integral exact.
class RadialPotential
{
public:
  RadialPotential(const PowerDiagram& diagram,
    const DenseCluster& cluster,
    const Eigen::VectorXd& targets,
    double totalMass)
  {
    double mass = 0.0;
    for (const int i : cluster.Sites)
    {
      const DoubleDouble radius = preciseDistance(diagram.sites(), i, cluster.Sites.front());
      mass += targets[i];
      const double slope = std::sqrt(mass / totalMass);
      const Knot before = this->Knots.empty() ? Knot{ 0.0, slope, 0.0 } : this->Knots.back();
      this->Knots.push_back({ radius,
        slope,
        before.Height + DoubleDouble(0.5 * (before.Slope + slope)) * (radius - before.Radius) });
    }
  }

  /// In the precision of @p radius.
  template <typename Real>
  Real operator()(const Real& radius) const
  {
    const Knot& outermost = this->Knots.back();
    if (!(radius < static_cast<Real>(outermost.Radius)))
    {
      return static_cast<Real>(outermost.Height) +
             (radius - static_cast<Real>(outermost.Radius)) * outermost.Slope;
    }
    const auto above = std::upper_bound(this->Knots.begin(),
      this->Knots.end(),
      radius,
      [](const Real& r, const Knot& knot) { return r < static_cast<Real>(knot.Radius); });
    const Knot& below = *(above - 1);
    const Real step = radius - static_cast<Real>(below.Radius);
    const double bend =
      0.5 * (above->Slope - below.Slope) / static_cast<double>(above->Radius - below.Radius);
    return static_cast<Real>(below.Height) + step * (below.Slope + step * bend);
  }

private:
  struct Knot
  {
    DoubleDouble Radius;
    double Slope;
    DoubleDouble Height;
  };
  std::vector<Knot> Knots; // the first at radius 0
};

} // namespace

std::vector<DenseCluster> denseClusters(const PowerDiagram& diagram, const Eigen::VectorXd& targets)
{
  const Eigen::VectorXd ratio = diagram.areas().array() / targets.array();
  std::vector<std::vector<int>> components;
  std::vector<int> innermost(ratio.size(), -1);
  for (const double denseRatio : DenseRatios)
  {
    std::vector<char> dense(ratio.size());
    std::transform(ratio.begin(),
      ratio.end(),
      dense.begin(),
      [denseRatio](double value) { return value < denseRatio; });
    for (std::vector<int>& sites : connectedSites(diagram, dense))
    {
      if (sites.size() > 1)
      {
        for (const int i : sites)
        {
          innermost[i] = static_cast<int>(components.size());
        }
        components.push_back(std::move(sites));
      }
    }
  }
  std::vector<DenseCluster> clusters(components.size());
  for (int i = 0; i < diagram.siteCount(); ++i)
  {
    if (innermost[i] >= 0)
    {
      clusters[innermost[i]].Sites.push_back(i);
      clusters[innermost[i]].Mass += targets[i];
    }
  }
  clusters.erase(std::remove_if(clusters.begin(),
                   clusters.end(),
                   [](const DenseCluster& cluster) { return cluster.Sites.empty(); }),
    clusters.end());
  for (DenseCluster& cluster : clusters)
  {
    std::vector<int>& sites = cluster.Sites;
    const int tip = *std::min_element(
      sites.begin(), sites.end(), [&ratio](int a, int b) { return ratio[a] < ratio[b]; });
    std::stable_sort(sites.begin(),
      sites.end(),
      [&](int a, int b)
      { return distance(diagram.sites(), a, tip) < distance(diagram.sites(), b, tip); });
  }
  return clusters;
}

PowerDiagram::Weights openingPotential(const PowerDiagram& diagram,
  const std::vector<DenseCluster>& clusters,
  const Eigen::VectorXd& targets,
  double totalMass)
{
  std::vector<RadialPotential> potentials;
  for (const DenseCluster& cluster : clusters)
  {
    potentials.emplace_back(diagram, cluster, targets, totalMass);
  }
  const Eigen::VectorXd nearest = nearestDistances(diagram);
  PowerDiagram::Weights sum = PowerDiagram::Weights::Zero(diagram.siteCount());
  tbb::parallel_for(0,
    diagram.siteCount(),
    [&](int i)
    {
      const bool close = nearest[i] < CloseDistance;
      double roundedSum = 0.0;
      for (std::size_t c = 0; c < clusters.size(); ++c)
      {
        const int tip = clusters[c].Sites.front();
        if (close)
        {
          sum[i] += potentials[c](preciseDistance(diagram.sites(), i, tip));
        }
        else
        {
          roundedSum += potentials[c](distance(diagram.sites(), i, tip));
        }
      }
      sum[i] += roundedSum;
    });
  return sum;
}

} // namespace flattening
