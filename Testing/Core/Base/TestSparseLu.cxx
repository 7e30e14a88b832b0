// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/SparseLu.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <random>

namespace
{

using namespace flattening;

// A matrix without symmetry, and without it in its pattern.
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
