// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/Transport.h"

#include "Base/Errors.h"
#include "Base/SparseFactorization.h"
#include "Transport/ConvexPotential.h"
#include "Transport/InitialWeights.h"
#include "Transport/VanishingCells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace flattening
{
namespace
{

// How far, as the logarithm of their greatest ratio to the present areas, the next targets on the way
// may lie. Steps that are accepted at once lengthen the way to the next ones, rejected trials shorten
// it.
constexpr double LongestWay = 2.3;
constexpr double ShortestWay = 0.1;
// How much of its area, or of its aim if that is smaller, a cell must keep in a step.
constexpr double KeptShare = 0.1;
// A cell error below which rounding is what may have stopped the iteration.
constexpr double NearlyThere = 1e-2;
// Error of a Newton step, relative to the areas and to what it is to change of them, and how often it is
// refined to get there.
constexpr double StepError = 1e-3;
constexpr int LargestRefinements = 10;
constexpr const char* StartStage = "First power diagram";
constexpr const char* Stage = "Optimal mass transport";

double relativeError(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets)
{
  return ((areas - targets).array() / targets.array()).abs().maxCoeff();
}

double largestLogRatio(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets)
{
  return areas.minCoeff() > 0.0 ? (targets.array() / areas.array()).log().abs().maxCoeff()
                                : std::numeric_limits<double>::infinity();
}

// The equations without that of one site: weights count up to a common constant, so its weight stays,
// and its cell takes what rounding leaves of the total area. It had better be a large one.
class ReducedSystem
{
public:
  explicit ReducedSystem(const Eigen::VectorXd& targets) { targets.maxCoeff(&this->Fixed); }

  // Minus the derivative of the areas by the weights.
  SparseMatrix jacobian(const PowerDiagram& diagram) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(3 * diagram.commonSides().size());
    for (const PowerDiagram::CommonSide& side : diagram.commonSides())
    {
      const double value = side.Length / (2.0 * side.Distance);
      const int i = this->row(std::max(side.First, side.Second));
      const int j = this->row(std::min(side.First, side.Second));
      for (const int k : { i, j })
      {
        if (k >= 0)
        {
          entries.emplace_back(k, k, value);
        }
      }
      if (i >= 0 && j >= 0)
      {
        entries.emplace_back(i, j, -value);
      }
    }
    const Eigen::Index n = diagram.siteCount() - 1;
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  Eigen::VectorXd reduced(const Eigen::VectorXd& values) const
  {
    Eigen::VectorXd result(values.size() - 1);
    result << values.head(this->Fixed), values.tail(values.size() - 1 - this->Fixed);
    return result;
  }

  Eigen::VectorXd expanded(const Eigen::VectorXd& values) const
  {
    Eigen::VectorXd result(values.size() + 1);
    result << values.head(this->Fixed), 0.0, values.tail(values.size() - this->Fixed);
    return result;
  }

private:
  int row(int site) const { return site == this->Fixed ? -1 : site - (site > this->Fixed ? 1 : 0); }

  Eigen::Index Fixed = 0;
};

// Starts: without weights (the paper's) and from the radially symmetric potential, which are gradients
// of convex functions; where sites lie too densely, also from the sums of each with the potential that
// opens the clusters, scaled back into the largest disk of the domain. None leaves a cell empty in the
// plane.
std::vector<PowerDiagram::Weights> starts(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  const ProgressCallback& progress)
{
  report(progress, 0.0, StartStage);
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
  report(progress, 0.0, StartStage);
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
  // Each slope adds to how far all others are pushed out; beyond their sum of 1 that costs more area
  // than the clusters gain.
  const double share = std::min(1.0, 1.0 / slope);
  const PowerDiagram::Weights opening = openingPotential(diagram, clusters, targets, targets.sum());
  for (const PowerDiagram::Weights& weights :
    { zero, radialPotentialWeights(diagram.sites(), rest, reach) })
  {
    // w = r^2 - 2 h, of the sum of potentials over the largest slope that it can have.
    const PowerDiagram::Weights potential =
      DoubleDouble(0.5) * (squares - weights) + DoubleDouble(share * reach) * opening;
    all.push_back(squares - DoubleDouble(2.0 / (1.0 + share * slope)) * potential);
  }
  return all;
}

// Of all starts the one whose cells are nearest to their targets; the diagram is its afterwards.
PowerDiagram::Weights startWeights(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  const Eigen::VectorXd& given,
  const ProgressCallback& progress)
{
  report(progress, 0.0, StartStage);
  double least = std::numeric_limits<double>::infinity();
  PowerDiagram::Weights best;
  std::vector<PowerDiagram::Weights> all;
  if (given.size() == targets.size() && given.allFinite())
  {
    all.push_back(given.cast<DoubleDouble>());
    if (diagram.update(all.front()) && largestLogRatio(diagram.areas(), targets) <= LongestWay)
    {
      return all.front(); // one step away
    }
  }
  const std::vector<PowerDiagram::Weights> own = starts(diagram, targets, progress);
  all.insert(all.end(), own.begin(), own.end());
  for (const PowerDiagram::Weights& weights : all)
  {
    report(progress, 0.0, StartStage);
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
  report(progress, 0.0, StartStage);
  diagram.update(best);
  return best;
}

// What @p step leaves of @p gap, in the linear model of the areas.
Eigen::VectorXd remainder(const PowerDiagram& diagram,
  const Eigen::VectorXd& gap,
  const PowerDiagram::Weights& step)
{
  Eigen::VectorXd rest = gap;
  for (const PowerDiagram::CommonSide& side : diagram.commonSides())
  {
    const double flow =
      side.Length / (2.0 * side.Distance) * static_cast<double>(step[side.First] - step[side.Second]);
    rest[side.First] -= flow;
    rest[side.Second] += flow;
  }
  return rest;
}

// The Newton step that brings the areas of @p diagram nearer to @p aims. Empty if there is none. Where
// sites nearly coincide, areas depend on differences of the step far below the last digit of a double:
// the solution is refined with the factor at hand.
PowerDiagram::Weights newtonStep(SparseCholesky& cholesky,
  const PowerDiagram& diagram,
  const Eigen::VectorXd& aims,
  const ProgressCallback& progress)
{
  const ReducedSystem system(aims);
  cholesky.compute(system.jacobian(diagram), progress, 0.0, Stage);
  if (cholesky.info() != Eigen::Success)
  {
    return {};
  }
  const Eigen::VectorXd gap = aims - diagram.areas();
  const Eigen::VectorXd scale = aims.cwiseMin(diagram.areas());
  PowerDiagram::Weights step = PowerDiagram::Weights::Zero(aims.size());
  Eigen::VectorXd rest = gap;
  const double least = StepError * std::min(1.0, (gap.array() / scale.array()).abs().maxCoeff());
  double error = std::numeric_limits<double>::infinity();
  for (int round = 0; round <= LargestRefinements; ++round)
  {
    const Eigen::VectorXd correction = cholesky.solve(system.reduced(rest));
    const PowerDiagram::Weights refined = step + system.expanded(correction).cast<DoubleDouble>();
    const Eigen::VectorXd nextRest = remainder(diagram, gap, refined);
    const double nextError = (nextRest.array() / scale.array()).abs().maxCoeff();
    if (!(nextError < error))
    {
      break;
    }
    step = refined;
    rest = nextRest;
    error = nextError;
    if (error < least)
    {
      break;
    }
  }
  return step;
}

// Close to the end the rounding of large cells' areas may hide the progress of small ones from the rule
// of acceptance: full steps as long as they help. Returns how many; the diagram is that of @p weights.
int finish(SparseCholesky& cholesky,
  PowerDiagram& diagram,
  PowerDiagram::Weights& weights,
  const Eigen::VectorXd& targets,
  double tolerance,
  double& error,
  const ProgressCallback& progress)
{
  for (int steps = 0;; ++steps)
  {
    const PowerDiagram::Weights step =
      error > tolerance ? newtonStep(cholesky, diagram, targets, progress) : PowerDiagram::Weights();
    if (step.size() == 0)
    {
      return steps;
    }
    const PowerDiagram::Weights next = weights + step;
    const double nextError = diagram.update(next) ? relativeError(diagram.areas(), targets) : error;
    if (!(nextError < 0.9 * error))
    {
      diagram.update(weights);
      return steps;
    }
    weights = next;
    error = nextError;
  }
}

} // namespace

TransportResult transportNewton(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  const TransportOptions& options,
  const ProgressCallback& progress)
{
  TransportResult result;
  result.Weights = startWeights(diagram, targets, options.StartWeights, progress);

  Eigen::VectorXd areas = diagram.areas();
  // Convergence rests on it: a bound that followed the areas down would let them vanish.
  const double smallest = 0.5 * std::min(areas.minCoeff(), targets.minCoeff());
  double error = relativeError(areas, targets);
  // Progress measures the way in decades, of ratios first and of the error afterwards.
  const double start = largestLogRatio(areas, targets) - std::log(options.Tolerance);
  double fraction = 0.0;
  double way = LongestWay;
  SparseCholesky cholesky;
  while (error > options.Tolerance)
  {
    const double ratio = largestLogRatio(areas, targets);
    const double decadesLeft = ratio + std::log(std::min(error, 1.0) / options.Tolerance);
    fraction = std::max(fraction, std::clamp(1.0 - decadesLeft / start, 0.0, 1.0));
    report(progress, fraction, Stage);
    if (result.NewtonIterations >= options.MaximumIterations)
    {
      break;
    }

    const double share = std::min(1.0, way / ratio);
    Eigen::VectorXd aims = targets;
    if (share < 1.0)
    {
      aims = areas.array().pow(1.0 - share) * targets.array().pow(share);
      aims *= targets.sum() / aims.sum();
    }

    const Eigen::VectorXd gap = aims - areas;
    const ProgressCallback atStep = atFraction(progress, fraction, Stage);
    const PowerDiagram::Weights step = newtonStep(cholesky, diagram, aims, atStep);
    if (step.size() == 0)
    {
      break;
    }

    const Eigen::VectorXd least = (KeptShare * areas.array().min(aims.array())).max(smallest);
    const Eigen::VectorXd slopes = ownSlopes(diagram);
    bool accepted = false;
    double length = 1.0;
    for (int trial = 0; trial < 30 && !accepted; ++trial, length *= 0.5)
    {
      report(progress, fraction, Stage);
      PowerDiagram::Weights weights = result.Weights + DoubleDouble(length) * step;
      const auto approaches = [&]
      { return (diagram.areas() - aims).norm() <= (1.0 - 0.5 * length) * gap.norm(); };
      accepted = diagram.update(weights, largestVanishing(diagram.siteCount())) && approaches() &&
                 feedVanishingCells(diagram, weights, least, slopes, atStep) && approaches();
      if (accepted)
      {
        result.Weights = weights;
        way =
          trial == 0 ? std::min(2.0 * way, LongestWay) : std::max(std::sqrt(length) * way, ShortestWay);
      }
    }
    ++result.NewtonIterations;
    if (!accepted)
    {
      diagram.update(result.Weights);
      if (error < NearlyThere)
      {
        result.NewtonIterations +=
          finish(cholesky, diagram, result.Weights, targets, options.Tolerance, error, atStep);
      }
      break; // at the rounding floor, or stuck: the error decides below
    }
    areas = diagram.areas();
    error = relativeError(areas, targets);
  }
  result.MaxCellError = error;
  if (!(error <= options.Tolerance))
  {
    std::ostringstream message;
    message
      << "the optimal transport stopped after " << result.NewtonIterations
      << " Newton steps at a cell error of " << error << ", above the tolerance " << options.Tolerance
      << ": slivers, horns or nearly coincident points set a floor in double precision; remesh the "
         "surface (Surface To Disk, Remesh) or raise Tolerance";
    throw ConvergenceError(message.str());
  }
  report(progress, 1.0, Stage);
  return result;
}

} // namespace flattening
