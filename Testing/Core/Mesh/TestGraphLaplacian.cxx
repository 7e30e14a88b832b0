// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/GraphLaplacian.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace flattening;

constexpr int Columns = 340;
constexpr int Rows = 310;

bool isBorder(int x, int y)
{
  return x == 0 || y == 0 || x == Columns - 1 || y == Rows - 1;
}

// A discrete harmonic function on the square grid: exp(-a x + i b y) where cosh(a) + cos(b) = 2.
std::complex<double> harmonic(int x, int y)
{
  constexpr double decay = 0.08; // to 1e-12 of the first column in the last one
  const double turn = std::acos(2.0 - std::cosh(decay));
  return std::polar(std::exp(-decay * x), turn * y);
}

// The weights of the inner vertices of the grid: all 0.5, or random powers of ten up to those of +-@p
// decades, the same in both directions.
std::vector<NeighbourWeight> gridWeights(int decades = 0)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-decades, decades);
  std::vector<double> strengths; // of the edges from each vertex along both axes
  for (int k = 0; k < 2 * Columns * Rows; ++k)
  {
    strengths.push_back(decades == 0 ? 0.5 : std::pow(10.0, exponent(random)));
  }
  std::vector<NeighbourWeight> weights;
  const std::vector<std::array<int, 2>> steps = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
  for (int y = 0; y < Rows; ++y)
  {
    for (int x = 0; x < Columns; ++x)
    {
      for (const auto& [dx, dy] : steps)
      {
        if (!isBorder(x, y))
        {
          const int neighbour = (y + dy) * Columns + x + dx;
          const int first = std::min(y * Columns + x, neighbour);
          weights.push_back({ y * Columns + x, neighbour, strengths[2 * first + (dy != 0)] });
        }
      }
    }
  }
  return weights;
}

WeightedMeans meansOfGrid(const std::vector<NeighbourWeight>& weights)
{
  std::vector<char> fixed(Columns * Rows, 0);
  for (int v = 0; v < Columns * Rows; ++v)
  {
    fixed[v] = isBorder(v % Columns, v / Columns);
  }
  return WeightedMeans(weights, WeightSymmetry::Symmetric, fixed);
}

TEST(WeightedMeans, KeepTheDigitsOfSmallPositionsOnLargeSurfaces)
{
  WeightedMeans means = meansOfGrid(gridWeights());
  ComplexVector positions(Columns * Rows, 0.0);
  for (int v = 0; v < Columns * Rows; ++v)
  {
    const int x = v % Columns;
    const int y = v / Columns;
    positions[v] = isBorder(x, y) ? harmonic(x, y) : 0.0;
  }
  int reports = 0;
  means.extend(positions,
    [&](double, const char*)
    {
      ++reports;
      return true;
    });
  EXPECT_GT(reports, 20) << "of multigrid cycles";
  double worst = 0.0;
  for (int v = 0; v < Columns * Rows; ++v)
  {
    const std::complex<double> expected = harmonic(v % Columns, v / Columns);
    worst = std::max(worst, std::abs(positions[v] - expected) / std::abs(expected));
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_THROW(means.extend(positions, [](double, const char*) { return false; }), Cancelled);
}

// The weights that are passed give the sum of all positions of a map that is extended from the border,
// such as the harmonic function and the constant 1.
TEST(WeightedMeans, PassWeightsToTheBorderOfLargeSurfaces)
{
  WeightedMeans means = meansOfGrid(gridWeights());
  const Eigen::VectorXd passed = means.passedToFixed(Eigen::VectorXd::Ones(Columns * Rows));
  std::complex<double> sum = 0.0;
  std::complex<double> expected = 0.0;
  double count = 0.0;
  for (int v = 0; v < Columns * Rows; ++v)
  {
    const int x = v % Columns;
    const int y = v / Columns;
    expected += harmonic(x, y);
    sum += isBorder(x, y) ? passed[v] * harmonic(x, y) : 0.0;
    count += isBorder(x, y) ? passed[v] : 0.0;
  }
  EXPECT_LT(std::abs(sum - expected), 1e-9 * std::abs(expected));
  EXPECT_NEAR(count, Columns * Rows, 1e-9 * Columns * Rows);
}

// Every inner vertex is the mean of its neighbours, whatever the weights: with multigrid cycles, with a
// factor after these did not converge, or with a factor alone.
TEST(WeightedMeans, OfWeightsOverManyDecadesAreMeansOnLargeSurfaces)
{
  for (const int decades : { 2, 3, 9 })
  {
    SCOPED_TRACE(decades);
    const std::vector<NeighbourWeight> weights = gridWeights(decades);
    WeightedMeans means = meansOfGrid(weights);
    ComplexVector positions(Columns * Rows, 0.0);
    for (int v = 0; v < Columns * Rows; ++v)
    {
      const int x = v % Columns;
      const int y = v / Columns;
      positions[v] = isBorder(x, y) ? std::complex<double>(x, y) : 0.0;
    }
    double last = 0.0;
    means.extend(positions,
      [&](double fraction, const char*)
      {
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
      });
    ComplexVector pulls(Columns * Rows, 0.0);
    std::vector<double> sums(Columns * Rows, 0.0);
    for (const NeighbourWeight& w : weights)
    {
      pulls[w.From] += w.Weight * (positions[w.To] - positions[w.From]);
      sums[w.From] += w.Weight;
    }
    double worst = 0.0; // distance from the mean
    for (int v = 0; v < Columns * Rows; ++v)
    {
      worst = std::max(worst, sums[v] > 0.0 ? std::abs(pulls[v]) / sums[v] : 0.0);
    }
    EXPECT_LT(worst, 1e-9);
  }
}

} // namespace
