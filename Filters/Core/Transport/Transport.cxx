// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/Transport.h"

#include "Base/Errors.h"
#include "Base/SparseFactorization.h"
#include "Transport/InitialWeights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// How far the next targets on the way may lie, as the greatest log ratio to the present areas: at most a
// decade. Steps that are accepted at once lengthen the way, rejected trials shorten it; that saves a
// third of the power diagrams on raw surfaces. The shortest way is a guard against standing still. It
// was found where one cell holds all others back, so that they come closer by a factor of 1.003 in a
// step: with 0.1 most of the 500 steps begin with five vain trials and take five times as long.
constexpr double LongestWay = 2.3;
constexpr double ShortestWay = 1e-3;
// The share of its area, or of its aim if that is smaller, that a cell must keep in a step. A choice: a
// larger share makes more steps fail, a smaller one lets cells vanish.
constexpr double KeptShare = 0.1;
// The most corrections of a trial step. A choice: with 1 a whole brain, remeshed, takes 52 steps, with 2
// 27, and with 6 19; with more than 6 no surface took less time.
constexpr int LargestCorrections = 6;
// The greatest share of sites that may be hidden for a trial step to be corrected. A choice: with more,
// the step is much too long.
constexpr double LargestHiddenShare = 0.02;
// A guard: shorter steps than 2^-29 change the areas by rounding only.
constexpr int LargestHalvings = 30;
// Below this cell error the rounding of large cells' areas may hide the progress of small cells from the
// sum of the squares, and a step that lowers the cell error is accepted, too. Far above it that would
// not converge.
constexpr double NearlyThere = 1e-2;
// The share to which such a step must lower the error. A convention: near the solution it squares it.
constexpr double LeastDecrease = 0.9;
// The most halvings below NearlyThere. A guard: where even a step of 2^-9 fails, rounding stands in the
// way, and still shorter steps would not reach the tolerance within the iterations that are allowed.
constexpr int LargestHalvingsNearby = 10;
// The error of a Newton step, relative to the areas and to their change, and how often it is refined to
// get there. Newton's method does not need more digits; one refinement is enough but for protrusions.
constexpr double StepError = 1e-3;
constexpr int LargestRefinements = 10;
constexpr const char* TransportStage = "Optimal mass transport";

double relativeError(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets)
{
  return ((areas - targets).array() / targets.array()).abs().maxCoeff();
}

// The Newton equations without that of one site: weights are unique up to a common constant, so the
// weight of that site stays, and its cell takes the rounding error of the total area. The site is the
// one of the largest target.
class ReducedSystem
{
public:
  explicit ReducedSystem(const Eigen::VectorXd& targets) { targets.maxCoeff(&this->Fixed); }

  // Minus the derivative of the areas by the weights, lower triangle.
  SparseMatrix jacobian(const PowerDiagram& diagram) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(3 * diagram.commonSides().size());
    for (const PowerDiagram::CommonSide& side : diagram.commonSides())
    {
      const double value = side.slope();
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

// The part of @p gap that @p step leaves in the linear model of the areas.
Eigen::VectorXd remainder(const PowerDiagram& diagram,
  const Eigen::VectorXd& gap,
  const PowerDiagram::Weights& step)
{
  Eigen::VectorXd rest = gap;
  for (const PowerDiagram::CommonSide& side : diagram.commonSides())
  {
    const double flow = side.slope() * static_cast<double>(step[side.First] - step[side.Second]);
    rest[side.First] -= flow;
    rest[side.Second] += flow;
  }
  return rest;
}

// The Newton step that brings the areas of @p diagram to @p aims in the linear model; empty if there is
// none. Where sites nearly coincide, areas depend on differences of the step far below the last digit of
// a double, and so the solution is refined iteratively with the factor at hand.
PowerDiagram::Weights newtonStep(SparseCholesky& cholesky,
  const PowerDiagram& diagram,
  const Eigen::VectorXd& aims,
  const ProgressCallback& progress)
{
  const ReducedSystem system(aims);
  cholesky.compute(system.jacobian(diagram), progress, 0.0, TransportStage);
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

// The damped Newton iteration; each step is a stage of run().
class NewtonIteration
{
public:
  NewtonIteration(PowerDiagram& diagram,
    const Eigen::VectorXd& targets,
    const TransportOptions& options,
    const ProgressCallback& progress)
    : Diagram(diagram)
    , Targets(targets)
    , Options(options)
    , Progress(progress)
  {
  }

  TransportResult run(const Eigen::VectorXd& startWeights)
  {
    this->start(startWeights);
    while (this->Result.MaxCellError > this->Options.Tolerance)
    {
      this->reportWay();
      if (this->Result.NewtonIterations >= this->Options.MaximumIterations)
      {
        break;
      }
      const Eigen::VectorXd aims = this->nextAims();
      const PowerDiagram::Weights step =
        newtonStep(this->Cholesky, this->Diagram, aims, this->atFraction());
      if (step.size() == 0)
      {
        break;
      }
      ++this->Result.NewtonIterations;
      if (!this->advance(step, aims))
      {
        break;
      }
      this->measure();
    }
    this->requireTolerance();
    report(this->Progress, 1.0, TransportStage);
    return std::move(this->Result);
  }

private:
  void start(const Eigen::VectorXd& startWeights)
  {
    this->Result.Weights = initialWeights(this->Diagram, this->Targets, startWeights, this->Progress);
    this->measure();
    this->SmallestArea = 0.5 * std::min(this->Areas.minCoeff(), this->Targets.minCoeff());
    this->StartDistance =
      largestLogRatio(this->Areas, this->Targets) - std::log(this->Options.Tolerance);
  }

  void measure()
  {
    this->Areas = this->Diagram.areas();
    this->Result.MaxCellError = relativeError(this->Areas, this->Targets);
  }

  // Progress is measured logarithmically, by the ratios of the areas first and by the error afterwards.
  void reportWay()
  {
    const double distance = largestLogRatio(this->Areas, this->Targets) +
                            std::log(std::min(this->Result.MaxCellError, 1.0) / this->Options.Tolerance);
    this->Fraction =
      std::max(this->Fraction, std::clamp(1.0 - distance / this->StartDistance, 0.0, 1.0));
    report(this->Progress, this->Fraction, TransportStage);
  }

  ProgressCallback atFraction() const
  {
    return flattening::atFraction(this->Progress, this->Fraction, TransportStage);
  }

  // The areas on the geometric way to the targets that lie as far off as Way allows.
  Eigen::VectorXd nextAims() const
  {
    const double share = std::min(1.0, this->Way / largestLogRatio(this->Areas, this->Targets));
    if (!(share < 1.0))
    {
      return this->Targets;
    }
    Eigen::VectorXd aims = this->Areas.array().pow(1.0 - share) * this->Targets.array().pow(share);
    aims *= this->Targets.sum() / aims.sum();
    return aims;
  }

  // Halves the step until the areas, with corrections, approach their aims and no cell vanishes. Returns
  // whether that succeeded; the weights are the new ones then, and those from before otherwise.
  bool advance(const PowerDiagram::Weights& step, const Eigen::VectorXd& aims)
  {
    const int halvings = this->isNearlyThere() ? LargestHalvingsNearby : LargestHalvings;
    double length = 1.0;
    for (int trial = 0; trial < halvings; ++trial, length *= 0.5)
    {
      PowerDiagram::Weights weights = this->Result.Weights + DoubleDouble(length) * step;
      if (this->correct(weights, aims, length))
      {
        this->Result.Weights = std::move(weights);
        this->Way = trial == 0 ? std::min(2.0 * this->Way, LongestWay)
                               : std::max(std::sqrt(length) * this->Way, ShortestWay);
        return true;
      }
    }
    this->Diagram.update(this->Result.Weights);
    return false;
  }

  // Updates the diagram with the weights after a trial step of @p length, and corrects them as long as
  // the step is not accepted and the areas come closer to those that the linear model promised. The
  // factor of the step serves its corrections too. Returns whether the step is accepted.
  bool correct(PowerDiagram::Weights& weights, const Eigen::VectorXd& aims, double length)
  {
    const ReducedSystem system(aims);
    const Eigen::VectorXd gap = aims - this->Areas;
    const Eigen::VectorXd promised = this->Areas + length * gap;
    const Eigen::VectorXd least =
      (KeptShare * this->Areas.array().min(aims.array())).max(this->SmallestArea);
    const int mostHidden = static_cast<int>(LargestHiddenShare * this->Diagram.siteCount());
    double missing = std::numeric_limits<double>::infinity();
    for (int correction = 0;; ++correction)
    {
      report(this->Progress, this->Fraction, TransportStage);
      if (!this->Diagram.update(weights, mostHidden))
      {
        return false;
      }
      const Eigen::VectorXd& areas = this->Diagram.areas();
      if ((areas.array() >= least.array()).all() &&
          ((areas - aims).norm() <= (1.0 - 0.5 * length) * gap.norm() || this->lowersError()))
      {
        return true;
      }
      const Eigen::VectorXd rest = promised - areas;
      if (correction == LargestCorrections || !(rest.norm() < missing))
      {
        return false;
      }
      missing = rest.norm();
      for (const PowerDiagram::HiddenSite& hidden : this->Diagram.hiddenSites())
      {
        weights[hidden.Site] += hidden.Lacking;
      }
      weights += system.expanded(this->Cholesky.solve(system.reduced(rest))).cast<DoubleDouble>();
    }
  }

  bool isNearlyThere() const { return this->Result.MaxCellError < NearlyThere; }

  // Whether the diagram's areas are nearly there and closer to the targets than those of the result.
  bool lowersError() const
  {
    return this->isNearlyThere() && relativeError(this->Diagram.areas(), this->Targets) <
                                      LeastDecrease * this->Result.MaxCellError;
  }

  void requireTolerance() const
  {
    if (this->Result.MaxCellError <= this->Options.Tolerance)
    {
      return;
    }
    std::ostringstream message;
    message
      << "the optimal transport stopped after " << this->Result.NewtonIterations
      << " Newton steps at a cell error of " << this->Result.MaxCellError << ", above the tolerance "
      << this->Options.Tolerance
      << ": slivers, thin protrusions or nearly coincident points set a floor in double precision; "
         "remesh the surface (Surface To Disk, Remesh) or raise Tolerance";
    throw ConvergenceError(message.str());
  }

  PowerDiagram& Diagram;
  const Eigen::VectorXd& Targets;
  const TransportOptions& Options;
  const ProgressCallback& Progress;
  SparseCholesky Cholesky;
  TransportResult Result;
  Eigen::VectorXd Areas; // of the cells for the weights of the result
  // The least area that a cell may get. The proof of convergence rests on it: a bound that followed the
  // areas down would let them vanish.
  double SmallestArea = 0.0;
  double StartDistance = 0.0; // of the areas at the start from the targets, for the progress
  double Fraction = 0.0;      // of the progress
  double Way = LongestWay;
};

} // namespace

TransportResult transportNewton(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  const TransportOptions& options,
  const ProgressCallback& progress,
  const Eigen::VectorXd& startWeights)
{
  if (!(options.Tolerance > 0.0))
  {
    throw InvalidInput("the tolerance of the cell areas is " + formatted(options.Tolerance) +
                       ": set it to a small positive number");
  }
  return NewtonIteration(diagram, targets, options, progress).run(startWeights);
}

} // namespace flattening
