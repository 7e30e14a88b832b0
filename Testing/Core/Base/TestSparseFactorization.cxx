// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/SparseFactorization.h"

#include "Base/InterruptibleCall.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <tbb/parallel_for.h>

#include <filesystem>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

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

// A matrix that is not symmetric, nor is its pattern.
Eigen::MatrixXd unsymmetric(int n)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
  {
    matrix(i, i) = 4.0 + value(random);
    matrix(i, (i + 1) % n) = value(random);
    matrix(i, (7 * i + 3) % n) += value(random);
  }
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

// A few more edges keep the order of elimination; very many more, or another size, do not.
TEST(SparseCholesky, HasEntriesOfTheInverse)
{
  const SparseMatrix matrix = laplacian(12, 5);
  SparseCholesky cholesky(EliminationOrder(), SparseCholesky::Kernel::Entries);
  cholesky.compute(matrix);
  const Eigen::MatrixXd inverse =
    Eigen::MatrixXd(SparseMatrix(matrix.selfadjointView<Eigen::Lower>())).inverse();
  const std::vector<int> unknowns{ 100, 3, 143, 4 };
  EXPECT_LT((cholesky.inverseAt(unknowns) - inverse(unknowns, unknowns)).norm(), 1e-13);
  EXPECT_EQ(cholesky.inverseAt({}).size(), 0);
}

TEST(SparseCholesky, OfAMatrixWithoutEntriesIsAFailure)
{
  SparseCholesky cholesky;
  cholesky.compute(SparseMatrix(5, 5));
  EXPECT_NE(cholesky.info(), Eigen::Success);
  EXPECT_LT(residual(cholesky, laplacian(5, 0)), 1e-12); // and works again
}

TEST(SparseFactorization, SolvesEverySystemOfASequence)
{
  SparseCholesky cholesky;
  for (const auto& [side, extra] :
    { std::pair{ 60, 0 }, { 60, 20 }, { 60, 3000 }, { 40, 0 }, { 60, 0 } })
  {
    EXPECT_LT(residual(cholesky, laplacian(side, extra)), 1e-11) << side << " " << extra;
  }
}

// An order that serves is kept, one that makes the factor too large is not.
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

// Without the lock, some of these factorizations fail with BLAS libraries that do not lock their
// buffers.
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

// With OpenMP, CHOLMOD would let four threads wait for each other at every supernode.
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

TEST(SparseFactorization, AConstantPatternIsAnalysedOnce)
{
  const SparseMatrix matrix = laplacian(60, 0);
  SparseCholesky cholesky(SparseCholesky(matrix).order());
  cholesky.expectConstantPattern();
  EXPECT_LT(residual(cholesky, matrix), 1e-11);
  const EliminationOrder order = cholesky.order();
  EXPECT_LT(residual(cholesky, 2.0 * matrix), 1e-11);
  EXPECT_EQ(cholesky.order().Unknowns, order.Unknowns);
}

// The calls are aborted in the middle, and their objects are destroyed before the abandoned work has
// ended.
TEST(SparseFactorization, AnAbortLeavesNothingBroken)
{
  const SparseMatrix matrix = laplacian(300, 0);
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.rows(), -1.0, 1.0);
  const auto stopAtSecondReport = []()
  {
    return ProgressCallback(
      [reports = 0](double fraction, const char* stage) mutable
      {
        EXPECT_EQ(fraction, 0.25);
        EXPECT_STREQ(stage, "factor");
        return ++reports < 2;
      });
  };
  const auto attempt = [](const auto& work)
  {
    try
    {
      work();
    }
    catch (const Cancelled&)
    {
    }
    callInterruptibly([]() {}, [](double, const char*) { return true; }, 0.0, "waiting for its end");
  };
  attempt([&]() { SparseCholesky().compute(matrix, stopAtSecondReport(), 0.25, "factor"); });
  attempt([&]() { SparseLu(matrix, stopAtSecondReport(), 0.25, "factor"); });
  attempt(
    [&]()
    {
      SparseCholesky::orderOf(
        matrix, SparseCholesky::Ordering::Thorough, stopAtSecondReport(), 0.25, "factor");
    });
  SparseCholesky reported;
  reported.compute(
    matrix, [](double, const char*) { return true; }, 0.25, "factor");
  SparseCholesky plain;
  plain.compute(matrix);
  EXPECT_EQ(reported.solve(right), plain.solve(right));
}

TEST(SparseFactorization, AnAbortBeforeTheStartFactorsNothing)
{
  const SparseMatrix matrix = laplacian(10, 0);
  const ProgressCallback stop = [](double, const char*) { return false; };
  SparseCholesky cholesky;
  EXPECT_THROW(cholesky.compute(matrix, stop, 0.0, "factor"), Cancelled);
  EXPECT_THROW(SparseLu(matrix, stop, 0.0, "factor"), Cancelled);
  EXPECT_THROW(
    SparseCholesky::orderOf(matrix, SparseCholesky::Ordering::Quick, stop, 0.0, "factor"), Cancelled);
}

TEST(SparseLu, SolvesTheMatrixAndItsTranspose)
{
  const Eigen::MatrixXd dense = unsymmetric(200);
  const SparseMatrix matrix = dense.sparseView();
  const SparseLu factors(matrix);
  ASSERT_EQ(factors.info(), Eigen::Success);
  Eigen::MatrixXd right(200, 2);
  right.col(0).setLinSpaced(-1.0, 2.0);
  right.col(1).setConstant(3.0);
  const Eigen::PartialPivLU<Eigen::MatrixXd> reference(dense);
  EXPECT_LT((factors.solve(right) - reference.solve(right)).cwiseAbs().maxCoeff(), 1e-13);
  const Eigen::VectorXd transposed = dense.transpose().partialPivLu().solve(right.col(0));
  EXPECT_LT((factors.solveTransposed(right.col(0)) - transposed).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(SparseLu, SaysThatAMatrixIsSingular)
{
  Eigen::MatrixXd dense = unsymmetric(20);
  dense.row(4).setZero();
  const SparseMatrix matrix = dense.sparseView();
  EXPECT_NE(SparseLu(matrix).info(), Eigen::Success);
}

} // namespace
