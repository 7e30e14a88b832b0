// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/SparseFactorization.h"

#include <gtest/gtest.h>

#include <tbb/parallel_for.h>

#include <filesystem>
#include <iterator>
#include <random>

namespace
{

using namespace flattening;

/// The graph Laplacian of a grid plus 1, with some edges more between random vertices.
SparseMatrix laplacian(int side, int extraEdges)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&entries](int i, int j)
  {
    entries.emplace_back(i, i, 1.0);
    entries.emplace_back(j, j, 1.0);
    entries.emplace_back(std::max(i, j), std::min(i, j), -1.0);
  };
  for (int v = 0; v < side * side; ++v)
  {
    entries.emplace_back(v, v, 1.0);
    if (v % side > 0)
    {
      couple(v, v - 1);
    }
    if (v >= side)
    {
      couple(v, v - side);
    }
  }
  std::mt19937 random(1);
  std::uniform_int_distribution<int> vertex(0, side * side - 2);
  for (int e = 0; e < extraEdges; ++e)
  {
    couple(vertex(random), side * side - 1);
    couple(vertex(random), vertex(random) + 1);
  }
  SparseMatrix matrix(side * side, side * side);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double residual(SparseCholesky& cholesky, const SparseMatrix& matrix)
{
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.rows(), -1.0, 1.0);
  cholesky.compute(matrix);
  EXPECT_EQ(cholesky.info(), Eigen::Success);
  const Eigen::VectorXd x = cholesky.solve(right);
  return (matrix.selfadjointView<Eigen::Lower>() * x - right).lpNorm<Eigen::Infinity>();
}

// Few more edges keep the order, very many do not, nor does another size.
TEST(SparseFactorization, SolvesEverySystemOfASequence)
{
  SparseCholesky cholesky;
  for (const auto& [side, extra] :
    { std::pair{ 60, 0 }, { 60, 20 }, { 60, 3000 }, { 40, 0 }, { 60, 0 } })
  {
    EXPECT_LT(residual(cholesky, laplacian(side, extra)), 1e-11) << side << " " << extra;
  }
}

// One that serves is kept, one that fills the factor is not.
TEST(SparseFactorization, BeginsWithAGivenOrder)
{
  const SparseMatrix matrix = laplacian(60, 0);
  const SparseCholesky found(matrix);
  EliminationOrder rows{ {}, found.order().Fill };
  for (int r = 0; r < matrix.rows(); ++r)
  {
    rows.Unknowns.push_back(r);
  }
  SparseCholesky refused(rows);
  EXPECT_LT(residual(refused, matrix), 1e-11);
  EXPECT_NE(refused.order().Unknowns, rows.Unknowns) << "row by row, the factor is twice as large";
  EXPECT_EQ(refused.order().Fill, rows.Fill);
  std::vector<int> similar = found.order().Unknowns;
  std::swap(similar[0], similar[1]);
  SparseCholesky kept(EliminationOrder{ similar, rows.Fill });
  EXPECT_LT(residual(kept, matrix), 1e-11);
  EXPECT_EQ(kept.order().Unknowns, similar);
}

// With BLAS libraries that do not lock their buffers, some of these factorizations fail.
TEST(SparseFactorization, MayBeUsedInSeveralThreadsAtOnce)
{
  const SparseMatrix matrix = laplacian(60, 300);
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.rows(), -1.0, 1.0);
  const Eigen::VectorXd alone = SparseCholesky(matrix).solve(right);
  std::vector<Eigen::VectorXd> together(100);
  tbb::parallel_for(0,
    static_cast<int>(together.size()),
    [&](int i) { together[i] = SparseCholesky(matrix).solve(right); });
  for (const Eigen::VectorXd& x : together)
  {
    ASSERT_EQ(x, alone);
  }
}

// CHOLMOD's OpenMP would have four threads wait for each other at every supernode.
TEST(SparseFactorization, StartsNoThreads)
{
  const std::filesystem::path tasks = "/proc/self/task"; // Linux only
  if (!std::filesystem::exists(tasks))
  {
    GTEST_SKIP();
  }
  const auto threads = [&tasks]()
  {
    return std::distance(
      std::filesystem::directory_iterator(tasks), std::filesystem::directory_iterator());
  };
  const auto before = threads();
  const SparseMatrix matrix = laplacian(300, 0);
  EXPECT_EQ(SparseCholesky(matrix).info(), Eigen::Success);
  EXPECT_EQ(threads(), before);
}

} // namespace
