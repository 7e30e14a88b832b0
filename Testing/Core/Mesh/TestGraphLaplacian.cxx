// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/GraphLaplacian.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
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

WeightedMeans meansOfGrid()
{
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
          weights.push_back({ y * Columns + x, (y + dy) * Columns + x + dx, 0.5 });
        }
      }
    }
  }
  return WeightedMeans(weights, WeightSymmetry::Symmetric, fixed);
}

TEST(WeightedMeans, KeepTheDigitsOfSmallPositionsOnLargeSurfaces)
{
  const WeightedMeans means = meansOfGrid();
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
  const Eigen::VectorXd passed = meansOfGrid().passedToFixed(Eigen::VectorXd::Ones(Columns * Rows));
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

} // namespace
