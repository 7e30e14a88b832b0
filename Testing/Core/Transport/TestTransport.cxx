// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/AbandonedCall.h"
#include "Support/SampleSurfaces.h"
#include "Transport/BoundaryPlacement.h"
#include "Transport/InitialWeights.h"
#include "Transport/Transport.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using samples::contains;
using samples::messageOf;
using samples::Pi;

Points2 sunflower(int n)
{
  Points2 sites(n, 2);
  const double goldenAngle = Pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < n; ++i)
  {
    const double r = std::sqrt((i + 0.5) / n);
    sites.row(i) << r * std::cos(i * goldenAngle), r * std::sin(i * goldenAngle);
  }
  return sites;
}

// Random targets, sum pi, evenly spread in their logarithm over twice as many decades.
Eigen::VectorXd randomTargets(int n, double decades, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-decades, decades);
  Eigen::VectorXd targets(n);
  for (int i = 0; i < n; ++i)
  {
    targets[i] = std::pow(10.0, uniform(random));
  }
  return targets * (Pi / targets.sum());
}

double cellError(const PowerDiagram& diagram, const Eigen::VectorXd& targets)
{
  return ((diagram.areas() - targets).array() / targets.array()).abs().maxCoeff();
}

TEST(Transport, CellsHaveTheirTargetAreas)
{
  for (const double decades : { 0.5, 1.5, 3.0 })
  {
    PowerDiagram diagram(sunflower(2000));
    const Eigen::VectorXd targets = randomTargets(2000, decades, 11);
    TransportOptions options;
    options.Tolerance = 1e-10;
    const TransportResult result = transportNewton(diagram, targets, options);
    EXPECT_LE(result.MaxCellError, 1e-10);
    EXPECT_DOUBLE_EQ(cellError(diagram, targets), result.MaxCellError);
    // The diagram is that of the returned weights.
    PowerDiagram again(sunflower(2000));
    ASSERT_TRUE(again.update(result.Weights));
    EXPECT_TRUE((again.areas().array() == diagram.areas().array()).all());
  }
}

// Puts sites into rows from @p first on, at distances from @p place that fall geometrically.
void addProtrusion(Points2& sites,
  int first,
  int count,
  const Eigen::RowVector2d& place,
  double from,
  double to)
{
  const double goldenAngle = Pi * (3.0 - std::sqrt(5.0));
  for (int k = 0; k < count; ++k)
  {
    const double r = from * std::pow(to / from, k / (count - 1.0));
    sites.row(first + k) =
      place + r * Eigen::RowVector2d(std::cos(k * goldenAngle), std::sin(k * goldenAngle));
  }
}

Eigen::RowVector2d centreOfProtrusion(int protrusion, int protrusions)
{
  return (0.15 + 0.7 * protrusion / protrusions) *
         Eigen::RowVector2d(std::cos(2.0 * protrusion), std::sin(2.0 * protrusion));
}

void expectFewSteps(const Points2& sites)
{
  PowerDiagram diagram(sites);
  const Eigen::VectorXd targets = Eigen::VectorXd::Constant(sites.rows(), Pi / sites.rows());
  const TransportResult result = transportNewton(diagram, targets);
  EXPECT_LE(result.MaxCellError, 1e-6);
  EXPECT_LE(cellError(diagram, targets), 1e-6);
  EXPECT_LE(result.NewtonIterations, 12);
}

// Where a surface has protrusions, the conformal map puts hundreds of sites as close together as doubles
// tell apart. The potential that opens them leaves the iteration little more to do than without.
TEST(Transport, ProtrusionsAreOpenedBeforehand)
{
  const int spread = 3000;
  const int protrusions = 12;
  const int perProtrusion = 150;
  // At 1e-14 the last digit of a double of order 1 is a cell's width away.
  for (const double tip : { 1e-7, 1e-11, 1e-13, 1e-14 })
  {
    SCOPED_TRACE(tip);
    Points2 sites(spread + protrusions * perProtrusion, 2);
    sites.topRows(spread) = sunflower(spread);
    for (int h = 0; h < protrusions; ++h)
    {
      addProtrusion(
        sites, spread + h * perProtrusion, perProtrusion, centreOfProtrusion(h, protrusions), 1e-3, tip);
    }
    expectFewSteps(sites);
  }
}

// Pairs of sites, in protrusions and elsewhere, whose distance is the last digit of a double of order 1.
// Neither weights nor Newton steps of double precision tell their cells apart.
TEST(Transport, NeighbouringDoublesHaveTheirCells)
{
  const int spread = 2000;
  const int protrusions = 10;
  const int perProtrusion = 60;
  const int twins = 200;
  constexpr double LastDigit = std::numeric_limits<double>::epsilon();
  Points2 sites(spread + protrusions * perProtrusion + twins, 2);
  sites.topRows(spread) = sunflower(spread);
  for (int h = 0; h < protrusions; ++h)
  {
    addProtrusion(
      sites, spread + h * perProtrusion, perProtrusion, centreOfProtrusion(h, protrusions), 1e-3, 1e-12);
  }
  // Half of them in the spread part, half in the protrusions.
  const int first = spread + protrusions * perProtrusion;
  for (int k = 0; k < twins; ++k)
  {
    const int original = k % 2 == 0 ? 7 * k : spread + 3 * k;
    sites.row(first + k) << sites(original, 0) + std::copysign(LastDigit, sites(original, 0)),
      sites(original, 1);
  }
  expectFewSteps(sites);
}

TEST(Transport, ProtrusionsUponProtrusionsAreOpenedToo)
{
  const int spread = 3000;
  const int protrusions = 4;
  const int branches = 5;
  const int perBranch = 150;
  Points2 sites(spread + protrusions * (branches + 1) * perBranch, 2);
  sites.topRows(spread) = sunflower(spread);
  int first = spread;
  for (int h = 0; h < protrusions; ++h)
  {
    const Eigen::RowVector2d place = centreOfProtrusion(h, protrusions);
    addProtrusion(sites, first, perBranch, place, 1e-3, 1e-6);
    first += perBranch;
    for (int b = 0; b < branches; ++b)
    {
      const Eigen::RowVector2d direction(std::cos(1.2 * b), std::sin(1.2 * b));
      addProtrusion(sites, first, perBranch, place + 1e-5 * direction, 1e-6, 1e-11);
      first += perBranch;
    }
  }
  expectFewSteps(sites);
}

// Small masses on the circle have cells so thin that a step fit for all others would empty them.
TEST(Transport, ThinCellsOnTheCircleHoldNothingBack)
{
  const int inner = 3000;
  const int outer = 200;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Points2 sites(inner + outer, 2);
  sites.topRows(inner) = 0.97 * sunflower(inner);
  Eigen::VectorXd targets(inner + outer);
  for (int i = 0; i < inner; ++i)
  {
    targets[i] = std::exp(6.0 * sites(i, 0));
  }
  for (int i = inner; i < inner + outer; ++i)
  {
    const double angle = 2.0 * Pi * uniform(random);
    sites.row(i) << std::cos(angle), std::sin(angle);
    targets[i] = 0.3 * std::exp(2.0 * uniform(random) - 1.0);
  }
  targets *= Pi / targets.sum();
  PowerDiagram diagram(sites);
  const TransportResult result = transportNewton(diagram, targets);
  EXPECT_LE(result.MaxCellError, 1e-6);
  EXPECT_LE(result.NewtonIterations, 20); // 121 if no step is corrected
}

// The areas of large cells are rounded by more than those by which small cells are off at the end, so
// that the sum of the squares does not tell whether a step is an improvement. With that sum alone the
// transport took 1,236 diagrams.
TEST(Transport, RoundingOfLargeCellsDoesNotHideSmallOnes)
{
  constexpr int Sites = 8000;
  PowerDiagram diagram(sunflower(Sites));
  Eigen::VectorXd targets = Eigen::VectorXd::Constant(Sites, Pi / Sites);
  for (int i = Sites / 4; i < Sites / 2; i += 97)
  {
    targets[i] *= 1e-7;
  }
  targets *= Pi / targets.sum();
  const TransportResult result = transportNewton(diagram, targets);
  EXPECT_LE(result.MaxCellError, 1e-6);
  EXPECT_LE(cellError(diagram, targets), 1e-6);
  EXPECT_LE(diagram.updates(), 30);
}

TEST(Transport, NothingToDoTakesNoStep)
{
  PowerDiagram diagram(sunflower(500));
  ASSERT_TRUE(diagram.update(PowerDiagram::Weights::Zero(500)));
  const Eigen::VectorXd targets = diagram.areas();
  const TransportResult result = transportNewton(diagram, targets);
  EXPECT_EQ(result.NewtonIterations, 0);
  EXPECT_LT((diagram.areas() - targets).cwiseAbs().maxCoeff(), 1e-15);
}

// The optimal map is the gradient of a convex function, so it is monotone: (c_i - c_j).(y_i - y_j) >= 0
// for the centroids of any two cells; and no exchange of two of them is cheaper.
TEST(Transport, CentroidsAreMonotone)
{
  constexpr int n = 600;
  PowerDiagram diagram(sunflower(n));
  transportNewton(diagram, randomTargets(n, 1.0, 12));
  const Points2& y = diagram.sites();
  const Points2& c = diagram.centroids();
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      ASSERT_GT((c.row(i) - c.row(j)).dot(y.row(i) - y.row(j)), 0.0);
    }
  }
}

// All sites in a ten-thousandth of the disk: without weights the areas range over six decades.
TEST(Transport, SpreadsWhatIsCrowdedAtTheCentre)
{
  const Points2 sites = 0.01 * sunflower(1000);
  PowerDiagram diagram(sites);
  const Eigen::VectorXd targets = Eigen::VectorXd::Constant(1000, Pi / 1000);
  const TransportResult result = transportNewton(diagram, targets);
  EXPECT_LE(cellError(diagram, targets), 1e-6);
  // Uniform to uniform is the dilation.
  EXPECT_LT((diagram.centroids() - sunflower(1000)).rowwise().norm().maxCoeff(), 0.05);
  EXPECT_LT(result.NewtonIterations, 20);
}

TEST(Transport, RadialPotentialKeepsEveryCell)
{
  Points2 sites = sunflower(3000);
  for (int i = 0; i < 3000; ++i)
  {
    sites.row(i) *= std::pow(sites.row(i).norm(), 3.0); // crowded at the centre
  }
  const Eigen::VectorXd masses = Eigen::VectorXd::Constant(3000, 1.0 / 3000);
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(radialPotentialWeights(sites, masses)));
  EXPECT_GT(diagram.areas().minCoeff(), 0.02 * Pi / 3000);
}

TEST(Transport, SaysHowFarItCameIfItCannotMeetTheTolerance)
{
  PowerDiagram diagram(sunflower(500));
  TransportOptions options;
  options.MaximumIterations = 1;
  const std::string message =
    messageOf<ConvergenceError>([&] { transportNewton(diagram, randomTargets(500, 2.0, 13), options); });
  EXPECT_TRUE(contains(message, "1 Newton steps at a cell error of ")) << message;
  EXPECT_TRUE(contains(message, "above the tolerance 1e-06")) << message;
}

TEST(Transport, ProgressGrowsAndCancels)
{
  const Eigen::VectorXd targets = randomTargets(500, 1.5, 14);
  std::vector<double> fractions;
  PowerDiagram diagram(sunflower(500));
  transportNewton(diagram,
    targets,
    {},
    [&](double fraction, const char*)
    {
      if (fractions.empty() || fraction != fractions.back()) // not repeated while a library is at work
      {
        fractions.push_back(fraction);
      }
      return true;
    });
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
  for (const double stop : fractions)
  {
    bool isOver = false;
    EXPECT_THROW(transportNewton(diagram,
                   targets,
                   {},
                   [&](double fraction, const char*)
                   {
                     EXPECT_FALSE(isOver) << "went on after the stop";
                     isOver = fraction >= stop;
                     return !isOver;
                   }),
      Cancelled);
  }
}

TEST(Transport, ReportsWhileALibraryIsBusy)
{
  const Eigen::VectorXd targets = randomTargets(500, 1.5, 14);
  PowerDiagram quiet(sunflower(500));
  PowerDiagram diagram(sunflower(500));
  transportNewton(quiet, targets);
  std::unique_ptr<samples::AbandonedCall> busy;
  double busySince = 0.0;
  int ofStart = 0;
  int reports = 0;
  transportNewton(diagram,
    targets,
    {},
    [&](double fraction, const char* stage)
    {
      const bool isStart = stage == std::string("First power diagram");
      ofStart += isStart ? 1 : 0;
      if (!busy && !isStart)
      {
        busySince = fraction;
        busy = std::make_unique<samples::AbandonedCall>();
      }
      if (busy && !busy->isOver() && ++reports == 10) // more than a step has of its own
      {
        EXPECT_EQ(fraction, busySince);
        busy->end();
      }
      return true;
    });
  EXPECT_TRUE(busy && busy->isOver());
  EXPECT_GE(ofStart, 5) << "one per diagram";
  EXPECT_TRUE((diagram.areas().array() == quiet.areas().array()).all());
}

TEST(Transport, SameBitsWhateverTheThreads)
{
  const Eigen::VectorXd targets = randomTargets(10000, 1.0, 15);
  PowerDiagram first(sunflower(10000));
  const TransportResult expected = transportNewton(first, targets);
  for (const std::size_t threads : { 1, 2, 4 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    PowerDiagram diagram(sunflower(10000));
    const TransportResult result = transportNewton(diagram, targets);
    EXPECT_TRUE((result.Weights.array() == expected.Weights.array()).all()) << threads;
    EXPECT_TRUE((diagram.centroids().array() == first.centroids().array()).all()) << threads;
  }
}

TEST(StrictlyIncreasingFit, KeepsWhatIncreases)
{
  const std::vector<double> values{ -1.0, 0.5, 0.5000001, 4.0 };
  EXPECT_EQ(strictlyIncreasingFit(values, 0.0), values);
  EXPECT_TRUE(strictlyIncreasingFit({}, 0.1).empty());
  EXPECT_EQ(strictlyIncreasingFit({ 3.0 }, 0.1), std::vector<double>{ 3.0 });
}

TEST(StrictlyIncreasingFit, PoolsAtTheMeanAndIncreases)
{
  const std::vector<double> fit = strictlyIncreasingFit({ 0.0, 0.3, 0.2, 0.1, 0.6 }, 0.0);
  ASSERT_EQ(fit.size(), 5u);
  EXPECT_EQ(fit[0], 0.0);
  EXPECT_EQ(fit[4], 0.6);
  // The pool {0.3, 0.2, 0.1} about its mean, a third of the gap of 0.2 to either side.
  EXPECT_NEAR(fit[1], 0.2 - 0.2 / 3.0, 1e-15);
  EXPECT_NEAR(fit[2], 0.2, 1e-15);
  EXPECT_NEAR(fit[3], 0.2 + 0.2 / 3.0, 1e-15);

  for (const auto& values : std::vector<std::vector<double>>{
         { 1.0, 1.0 }, { 5.0, 4.0, 3.0, 2.0, 1.0 }, { 0.0, 0.0, 0.0, 1.0, 0.5, 2.0, 2.0 } })
  {
    const std::vector<double> increasing = strictlyIncreasingFit(values, 0.0);
    EXPECT_TRUE(std::adjacent_find(increasing.begin(), increasing.end(), std::greater_equal<>()) ==
                increasing.end());
    EXPECT_NEAR(std::accumulate(increasing.begin(), increasing.end(), 0.0),
      std::accumulate(values.begin(), values.end(), 0.0),
      1e-14);
  }
}

// Two pools nearer to each other than rounding, as where thousands of cells have no part of the
// boundary: the gaps were lost.
TEST(StrictlyIncreasingFit, KeepsTheLeastGap)
{
  std::vector<double> values;
  for (int k = 0; k < 5000; ++k)
  {
    values.push_back(k < 2500 ? 1.0 : std::nextafter(1.0, 2.0));
  }
  values.push_back(1.00001);
  constexpr double leastGap = 1e-7;
  const std::vector<double> fit = strictlyIncreasingFit(values, leastGap);
  for (std::size_t k = 1; k < fit.size(); ++k)
  {
    EXPECT_GE(fit[k] - fit[k - 1], leastGap * (1.0 - 1e-6)) << k;
  }
  EXPECT_NEAR(std::accumulate(fit.begin(), fit.end(), 0.0),
    std::accumulate(values.begin(), values.end(), 0.0),
    1e-9);
}

// Sites around the circle whose cells' arcs come in order keep their arcs' middles, exactly.
TEST(BoundaryAngles, AreTheMiddlesOfTheArcs)
{
  constexpr int n = 40;
  Points2 sites(n + 1, 2);
  std::vector<int> loop(n);
  std::vector<int> siteOfVertex(n + 1);
  for (int k = 0; k < n; ++k)
  {
    const double angle = 2.0 * Pi * (k + 0.3 * std::sin(5.0 * k)) / n + 2.5;
    sites.row(k) << std::cos(angle), std::sin(angle);
    loop[k] = k;
    siteOfVertex[k] = k;
  }
  sites.row(n).setZero();
  siteOfVertex[n] = n;
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(PowerDiagram::Weights::Zero(n + 1)));
  const std::vector<double> angles = boundaryParameters(diagram, { loop, {}, {} }, siteOfVertex);
  for (int k = 0; k < n; ++k)
  {
    EXPECT_NEAR(std::remainder(angles[k] - diagram.boundaryPart(k).Middle, 2.0 * Pi), 0.0, 1e-13);
    if (k > 0)
    {
      EXPECT_GT(angles[k], angles[k - 1]);
    }
  }
  EXPECT_LT(angles.back() - angles.front(), 2.0 * Pi);
}

// Boundary vertices that share a site, and whose order the arcs contradict, still come in order.
TEST(BoundaryAngles, KeepTheLoopsOrder)
{
  constexpr int n = 30;
  Points2 sites(n, 2);
  for (int k = 0; k < n; ++k)
  {
    sites.row(k) << std::cos(2.0 * Pi * k / n), std::sin(2.0 * Pi * k / n);
  }
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(PowerDiagram::Weights::Zero(n)));
  std::vector<int> loop(n);
  std::iota(loop.begin(), loop.end(), 0);
  std::vector<int> siteOfVertex = loop;
  std::swap(siteOfVertex[7], siteOfVertex[8]);
  siteOfVertex[20] = siteOfVertex[21];
  std::swap(siteOfVertex[0], siteOfVertex[n - 1]);
  const std::vector<double> angles = boundaryParameters(diagram, { loop, {}, {} }, siteOfVertex);
  for (int k = 1; k < n; ++k)
  {
    EXPECT_GT(angles[k], angles[k - 1]) << k;
  }
  EXPECT_LT(angles.back() - angles.front(), 2.0 * Pi);
  EXPECT_NEAR(std::remainder(angles[12] - 2.0 * Pi * 12 / n, 2.0 * Pi), 0.0, 1e-13)
    << "far from all that";
}

} // namespace
