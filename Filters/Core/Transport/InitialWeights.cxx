// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/InitialWeights.h"

#include "Base/Errors.h"
#include "Mesh/DisjointSets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// A start with all cells within this log ratio of their targets, about a decade, is one Newton step
// away: no better one is looked for.
constexpr double NearRatio = 2.3;
// The levels of area over target below which cells are dense: sites of a level are opened about a tip of
// their own. Steps of 1e4 down to the smallest cells that occur; with the first level alone, protrusions
// upon protrusions keep nearly empty cells.
constexpr double DenseRatios[] = { 1e-3, 1e-7, 1e-11, 1e-15, 1e-19 };
// Sites nearer to a neighbour get potentials of twice the precision of double. For the others the
// rounding of a weight, 1e-16, moves the sides of cells by at most 1e-10 of the disk.
constexpr double CloseDistance = 1e-6;
constexpr const char* DiagramStage = "First power diagram";

// The members of a dense cluster.
struct DenseCluster
{
  std::vector<int> Sites; // by distance from the first, which has the least area for its mass
  double Mass = 0.0;
};

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

PowerDiagram::Weights squaredRadii(const Points2& sites)
{
  PowerDiagram::Weights squares(sites.rows());
  for (Eigen::Index i = 0; i < sites.rows(); ++i)
  {
    squares[i] =
      DoubleDouble::product(sites(i, 0), sites(i, 0)) + DoubleDouble::product(sites(i, 1), sites(i, 1));
  }
  return squares;
}

// The distance of every site from the nearest neighbour in the diagram.
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

// The connected components of the sites that are marked in @p dense, in the order of their lowest sites.
std::vector<std::vector<int>> connectedSites(const PowerDiagram& diagram, const std::vector<char>& dense)
{
  DisjointSets sets(dense.size());
  for (const PowerDiagram::CommonSide& side : diagram.commonSides())
  {
    if (dense[side.First] && dense[side.Second])
    {
      sets.join(side.First, side.Second);
    }
  }
  std::vector<std::vector<int>> components;
  std::vector<int> number(dense.size(), -1);
  for (int i = 0; i < diagram.siteCount(); ++i)
  {
    if (dense[i])
    {
      int& entry = number[sets.find(i)];
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

// Clusters of at least two sites. A site belongs to the cluster of the lowest level that it is in.
std::vector<DenseCluster> denseClusters(const PowerDiagram& diagram, const Eigen::VectorXd& targets)
{
  const Eigen::VectorXd ratio = diagram.areas().array() / targets.array();
  std::size_t components = 0;
  std::vector<int> innermost(ratio.size(), -1);
  for (const double denseRatio : DenseRatios)
  {
    std::vector<char> dense(ratio.size());
    std::transform(ratio.begin(),
      ratio.end(),
      dense.begin(),
      [denseRatio](double value) { return value < denseRatio; });
    for (const std::vector<int>& sites : connectedSites(diagram, dense))
    {
      if (sites.size() > 1)
      {
        for (const int i : sites)
        {
          innermost[i] = static_cast<int>(components);
        }
        ++components;
      }
    }
  }
  std::vector<DenseCluster> clusters(components);
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

// A convex potential h(r), radially symmetric about a point: h'(r) is the radius of the disk with the
// mass within r, where the total mass has radius 1. Between two radii h' runs linearly, which keeps h
// strictly convex and its integral exact.
class RadialPotential
{
public:
  explicit RadialPotential(double totalMass)
    : TotalMass(totalMass)
  {
  }

  // Adds the mass at a radius beyond all others and returns the potential there.
  const DoubleDouble& extend(const DoubleDouble& radius, double mass)
  {
    this->Mass += mass;
    const double slope = std::sqrt(this->Mass / this->TotalMass);
    const Knot before = this->Knots.empty() ? Knot{ 0.0, 0.0, 0.0 } : this->Knots.back();
    this->Knots.push_back({ radius,
      slope,
      before.Height + DoubleDouble(0.5 * (before.Slope + slope)) * (radius - before.Radius) });
    return this->Knots.back().Height;
  }

  // The potential in the precision of @p radius. The first mass must be at radius 0.
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
  double TotalMass;
  double Mass = 0.0;
  std::vector<Knot> Knots; // by radius
};

// The sum of the clusters' potentials at every site.
PowerDiagram::Weights openingPotential(const PowerDiagram& diagram,
  const std::vector<DenseCluster>& clusters,
  const Eigen::VectorXd& targets)
{
  std::vector<RadialPotential> potentials;
  for (const DenseCluster& cluster : clusters)
  {
    RadialPotential& potential = potentials.emplace_back(targets.sum());
    for (const int i : cluster.Sites)
    {
      potential.extend(preciseDistance(diagram.sites(), i, cluster.Sites.front()), targets[i]);
    }
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

// The starts that do not need an earlier result. The sums with the opening potential are scaled back
// into the largest disk of the domain.
std::vector<PowerDiagram::Weights> starts(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  const ProgressCallback& progress)
{
  report(progress, 0.0, DiagramStage);
  const PowerDiagram::Weights zero = PowerDiagram::Weights::Zero(diagram.siteCount());
  const PowerDiagram::Weights squares = squaredRadii(diagram.sites());
  const double reach = diagram.domain().innerRadius();
  std::vector<PowerDiagram::Weights> all{ zero,
    radialPotentialWeights(diagram.sites(), targets, reach) };
  const std::vector<DenseCluster> clusters =
    diagram.update(zero) ? denseClusters(diagram, targets) : std::vector<DenseCluster>();
  if (clusters.empty())
  {
    return all;
  }
  report(progress, 0.0, DiagramStage);
  Eigen::VectorXd rest = targets;
  double slope = 0.0;
  for (const DenseCluster& cluster : clusters)
  {
    slope += std::sqrt(cluster.Mass / targets.sum());
    for (const int i : cluster.Sites)
    {
      rest[i] = 0.0;
    }
  }
  // Each slope adds to the distance by which all other sites are pushed out; beyond a sum of 1 that
  // costs more area than the clusters gain.
  const double share = std::min(1.0, 1.0 / slope);
  const PowerDiagram::Weights opening = openingPotential(diagram, clusters, targets);
  for (const PowerDiagram::Weights& weights :
    { zero, radialPotentialWeights(diagram.sites(), rest, reach) })
  {
    // w = r^2 - 2 h for the sum of both potentials, divided by its largest possible slope.
    const PowerDiagram::Weights potential =
      DoubleDouble(0.5) * (squares - weights) + DoubleDouble(share * reach) * opening;
    all.push_back(squares - DoubleDouble(2.0 / (1.0 + share * slope)) * potential);
  }
  return all;
}

} // namespace

PowerDiagram::Weights radialPotentialWeights(const Points2& sites,
  const Eigen::VectorXd& masses,
  double reach)
{
  const PowerDiagram::Weights squares = squaredRadii(sites);
  std::vector<int> order(sites.rows());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(),
    order.end(),
    [&squares](int a, int b) { return squares[a] != squares[b] ? squares[a] < squares[b] : a < b; });
  RadialPotential potential(masses.sum());
  PowerDiagram::Weights weights(sites.rows());
  for (const int i : order)
  {
    weights[i] = squares[i] - DoubleDouble(2.0 * reach) * potential.extend(sqrt(squares[i]), masses[i]);
  }
  return weights;
}

double largestLogRatio(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets)
{
  return areas.minCoeff() > 0.0 ? (targets.array() / areas.array()).log().abs().maxCoeff()
                                : std::numeric_limits<double>::infinity();
}

PowerDiagram::Weights initialWeights(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  const Eigen::VectorXd& given,
  const ProgressCallback& progress)
{
  report(progress, 0.0, DiagramStage);
  double least = std::numeric_limits<double>::infinity();
  PowerDiagram::Weights best;
  std::vector<PowerDiagram::Weights> all;
  if (given.size() == targets.size() && given.allFinite())
  {
    all.push_back(given.cast<DoubleDouble>());
    if (diagram.update(all.front()) && largestLogRatio(diagram.areas(), targets) <= NearRatio)
    {
      return all.front();
    }
  }
  const std::vector<PowerDiagram::Weights> own = starts(diagram, targets, progress);
  all.insert(all.end(), own.begin(), own.end());
  for (const PowerDiagram::Weights& weights : all)
  {
    report(progress, 0.0, DiagramStage);
    const double ratio = diagram.update(weights) ? largestLogRatio(diagram.areas(), targets)
                                                 : std::numeric_limits<double>::infinity();
    if (ratio < least)
    {
      least = ratio;
      best = weights;
    }
  }
  if (std::isinf(least))
  {
    throw ConvergenceError(
      "the transport has no start without empty power cells: sites of the conformal map lie "
      "too close together for double precision; remesh the surface (Surface To Disk, Remesh)");
  }
  report(progress, 0.0, DiagramStage);
  diagram.update(best);
  return best;
}

} // namespace flattening
