// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/MultigridSolver.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using namespace flattening;

// The Laplacian of a triangular grid of @p side by @p side vertices within a border that is fixed. The
// couplings along the first axis are @p anisotropy times as strong as the others, and the vertices have
// a random order, as in the memory of a mesh.
SparseMatrix laplacian(int side, double anisotropy)
{
  std::vector<int> order(side * side);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  std::vector<Eigen::Triplet<double>> entries;
  const std::vector<std::array<int, 2>> neighbours = { { 1, 0 }, { 0, 1 }, { 1, 1 } };
  for (int x = -1; x < side; ++x)
  {
    for (int y = -1; y < side; ++y)
    {
      const auto row = [&](int i, int j)
      { return i >= 0 && i < side && j >= 0 && j < side ? order[i * side + j] : -1; };
      for (const auto& [dx, dy] : neighbours)
      {
        const int a = row(x, y);
        const int b = row(x + dx, y + dy);
        const double weight = dy == 0 ? anisotropy : 1.0;
        if (a >= 0)
        {
          entries.emplace_back(a, a, weight);
        }
        if (b >= 0)
        {
          entries.emplace_back(b, b, weight);
        }
        if (a >= 0 && b >= 0)
        {
          entries.emplace_back(std::max(a, b), std::min(a, b), -weight);
        }
      }
    }
  }
  SparseMatrix matrix(side * side, side * side);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::MatrixXd randomColumns(Eigen::Index rows, int columns)
{
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&](auto, auto) { return normal(random); });
}

TEST(MultigridSolver, SolvesAsAFactorDoes)
{
  const SparseMatrix lower = laplacian(180, 1.0);
  const Eigen::MatrixXd right = randomColumns(lower.rows(), 2);
  MultigridSolver solver;
  solver.setMatrix(lower);
  ASSERT_TRUE(solver.computeLevels());
  Eigen::MatrixXd found;
  ASSERT_TRUE(solver.solve(right, 1e-12, found));
  const Eigen::MatrixXd expected = SparseCholesky(lower).solve(right);
  EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm());
  Eigen::MatrixXd first;
  ASSERT_TRUE(solver.solve(right.leftCols(1), 1e-12, first));
  EXPECT_LT((first - expected.leftCols(1)).norm(), 1e-9 * expected.norm());
}

TEST(MultigridSolver, IterationsDoNotGrowWithTheSize)
{
  const auto iterations = [](int side, double anisotropy)
  {
    const SparseMatrix lower = laplacian(side, anisotropy);
    MultigridSolver solver;
    solver.setMatrix(lower);
    EXPECT_TRUE(solver.computeLevels());
    Eigen::MatrixXd found;
    EXPECT_TRUE(solver.solve(randomColumns(lower.rows(), 1), 1e-8, found));
    return solver.iterations();
  };
  EXPECT_LE(iterations(180, 1.0), 12);
  EXPECT_LE(iterations(720, 1.0), 15);
  EXPECT_LE(iterations(360, 100.0), 15) << "strong along one axis";
}

TEST(MultigridSolver, BitsDoNotDependOnThreads)
{
  const SparseMatrix lower = laplacian(200, 3.0);
  const Eigen::MatrixXd right = randomColumns(lower.rows(), 2);
  std::vector<Eigen::MatrixXd> found(3);
  for (int k = 0; k < 3; ++k)
  {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1 << k);
    MultigridSolver solver;
    solver.setMatrix(lower);
    ASSERT_TRUE(solver.computeLevels());
    ASSERT_TRUE(solver.solve(right, 1e-8, found[k]));
  }
  EXPECT_TRUE((found[0].array() == found[1].array()).all());
  EXPECT_TRUE((found[0].array() == found[2].array()).all());
}

TEST(MultigridSolver, LevelsServeASimilarMatrix)
{
  const SparseMatrix lower = laplacian(200, 1.0);
  const Eigen::MatrixXd right = randomColumns(lower.rows(), 1);
  MultigridSolver solver;
  solver.setMatrix(laplacian(200, 1.5));
  ASSERT_TRUE(solver.computeLevels());
  solver.setMatrix(lower);
  Eigen::MatrixXd found;
  ASSERT_TRUE(solver.solve(right, 1e-8, found));
  EXPECT_LT((lower.selfadjointView<Eigen::Lower>() * found - right).norm(), 1.01e-8 * right.norm());
}

TEST(MultigridSolver, TinyAndZeroRightSidesAreSolved)
{
  const SparseMatrix lower = laplacian(120, 1.0);
  Eigen::MatrixXd right = randomColumns(lower.rows(), 2);
  right.col(0) *= 1e-100;
  right.col(1).setZero();
  MultigridSolver solver;
  solver.setMatrix(lower);
  ASSERT_TRUE(solver.computeLevels());
  Eigen::MatrixXd found;
  ASSERT_TRUE(solver.solve(right, 1e-8, found));
  const Eigen::VectorXd residual = lower.selfadjointView<Eigen::Lower>() * found.col(0) - right.col(0);
  EXPECT_LT((residual * 1e100).norm(), 1e-7 * (right.col(0) * 1e100).norm());
  EXPECT_EQ(found.col(1).cwiseAbs().maxCoeff(), 0.0);
}

TEST(MultigridSolver, SaysThatAMatrixIsIndefinite)
{
  const SparseMatrix lower = laplacian(120, 1.0);
  MultigridSolver solver;
  solver.setMatrix(-lower);
  EXPECT_FALSE(solver.computeLevels());
  // Indefinite, but with a positive diagonal.
  SparseMatrix shifted = lower;
  shifted.diagonal().array() -= 0.5;
  solver.setMatrix(shifted);
  Eigen::MatrixXd found;
  EXPECT_FALSE(solver.computeLevels() && solver.solve(randomColumns(lower.rows(), 1), 1e-8, found));
}

TEST(MultigridSolver, IsAborted)
{
  const SparseMatrix lower = laplacian(120, 1.0);
  for (int most = 0; most < 5; ++most)
  {
    int reports = 0;
    const ProgressCallback progress = [&](double, const char*) { return reports++ < most; };
    MultigridSolver solver;
    solver.setMatrix(lower);
    Eigen::MatrixXd found;
    EXPECT_THROW(
      {
        solver.computeLevels(progress);
        solver.solve(randomColumns(lower.rows(), 1), 1e-8, found, progress);
      },
      Cancelled)
      << most;
    EXPECT_EQ(reports, most + 1);
  }
}

} // namespace
