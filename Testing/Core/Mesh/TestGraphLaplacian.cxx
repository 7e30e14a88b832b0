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

// The means of a grid whose weights are 0.5, or random powers of ten up to those of +-@p decades.
WeightedMeans meansOfGrid(int decades = 0)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-decades, decades);
  std::vector<double> strengths; // of the edges from each vertex along both axes
  for (int k = 0; k < 2 * Columns * Rows; ++k)
  {
    strengths.push_back(decades == 0 ? 0.5 : std::pow(10.0, exponent(random)));
  }
  std::vector<NeighbourWeight> weights;
  std::vector<char> fixed(Columns * Rows, 0);
  const std::vector<std::array<int, 2>> steps = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
  for (int y = 0; y < Rows; ++y)
  {
    for (int x = 0; x < Columns; ++x)
    {
      fixed[y * Columns + x] = isBorder(x, y);
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
  return WeightedMeans(weights, WeightSymmetry::Symmetric, fixed);
}

TEST(WeightedMeans, KeepTheDigitsOfSmallPositionsOnLargeSurfaces)
{
  WeightedMeans means = meansOfGrid();
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

TEST(WeightedMeans, PassTheWholeWeightToTheBorderOfLargeSurfaces)
{
  WeightedMeans means = meansOfGrid();
  const Eigen::VectorXd passed = means.passedToFixed(Eigen::VectorXd::Ones(Columns * Rows));
  double sum = 0.0;
  for (int v = 0; v < Columns * Rows; ++v)
  {
    sum += isBorder(v % Columns, v / Columns) ? passed[v] : 0.0;
  }
  EXPECT_NEAR(sum, Columns * Rows, 1e-7 * Columns * Rows);
  // The longer sides get the larger shares, by symmetry the same on both.
  EXPECT_NEAR(passed[Columns / 2], passed[(Rows - 1) * Columns + Columns / 2], 1e-6);
  EXPECT_NEAR(passed[Rows / 2 * Columns], passed[Rows / 2 * Columns + Columns - 1], 1e-6);
}

// Every vertex lies between its neighbours, whatever their weights: within the square of the border.
TEST(WeightedMeans, OfWeightsOverManyDecadesLieWithinTheBorderOfLargeSurfaces)
{
  for (const int decades : { 2, 3, 9 })
  {
    WeightedMeans means = meansOfGrid(decades);
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
    for (const std::complex<double>& z : positions)
    {
      ASSERT_TRUE(z.real() >= -1e-6 && z.real() <= Columns - 1 + 1e-6) << decades;
      ASSERT_TRUE(z.imag() >= -1e-6 && z.imag() <= Rows - 1 + 1e-6) << decades;
    }
  }
}

} // namespace
