// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/LaggedSolver.h"

#include "Support/AbandonedCall.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace
{

using namespace flattening;

// Springs of random strength, up to exp(@p spread), between neighbours of a grid, and to the ground.
SparseMatrix springs(int side, double spread, int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> logStrength(0.0, spread);
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](int i, int j)
  {
    const double strength = std::exp(logStrength(random));
    entries.emplace_back(i, i, strength);
    entries.emplace_back(j, j, strength);
    entries.emplace_back(std::max(i, j), std::min(i, j), -strength);
  };
  for (int v = 0; v < side * side; ++v)
  {
    entries.emplace_back(v, v, 0.01);
    if (v % side > 0)
    {
      couple(v, v - 1);
    }
    if (v >= side)
    {
      couple(v, v - side);
    }
  }
  SparseMatrix matrix(side * side, side * side);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double relativeResidual(LaggedSolver& solver, const SparseMatrix& lower, double tolerance)
{
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(lower.rows(), -1.0, 1.0);
  Eigen::VectorXd x;
  EXPECT_TRUE(solver.solve(lower, right, tolerance, x));
  return (lower.selfadjointView<Eigen::Lower>() * x - right).norm() / right.norm();
}

TEST(LaggedSolver, OneFactorServesSimilarMatrices)
{
  LaggedSolver solver;
  for (int seed = 0; seed < 6; ++seed)
  {
    const double tolerance = std::pow(10.0, -2 - seed);
    EXPECT_LE(relativeResidual(solver, springs(50, 0.5, seed), tolerance), tolerance) << seed;
  }
  EXPECT_EQ(solver.factorizations(), 1);
  EXPECT_LT(solver.iterations(), 60);
}

TEST(LaggedSolver, ReportsWhileItFactorsAndAtEveryIteration)
{
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(2500, -1.0, 1.0);
  Eigen::VectorXd quiet;
  Eigen::VectorXd x;
  LaggedSolver quietSolver;
  LaggedSolver solver;
  samples::AbandonedCall busy;
  int reports = 0;
  const ProgressCallback progress = [&](double, const char*)
  {
    if (++reports == 5)
    {
      busy.end();
    }
    return true;
  };
  quietSolver.solve(springs(50, 0.5, 0), right, 1e-4, quiet);
  solver.solve(springs(50, 0.5, 0), right, 1e-4, x, progress);
  EXPECT_TRUE(busy.isOver());
  EXPECT_TRUE((x.array() == quiet.array()).all());
  reports = 0;
  quietSolver.solve(springs(50, 0.5, 1), right, 1e-4, quiet);
  solver.solve(springs(50, 0.5, 1), right, 1e-4, x, progress);
  EXPECT_EQ(solver.factorizations(), 1);
  EXPECT_EQ(reports, solver.iterations());
  EXPECT_TRUE((x.array() == quiet.array()).all());
}

TEST(LaggedSolver, AnotherMatrixIsFactored)
{
  LaggedSolver solver;
  for (int seed = 0; seed < 4; ++seed)
  {
    EXPECT_LE(relativeResidual(solver, springs(50, 12.0, seed), 1e-8), 1e-8) << seed;
  }
  EXPECT_EQ(solver.factorizations(), 4);
  EXPECT_LE(relativeResidual(solver, springs(30, 0.5, 1), 1e-8), 1e-8) << "of another size";
  EXPECT_EQ(solver.factorizations(), 5);
}

TEST(LaggedSolver, ForetellsIterationsAndForgets)
{
  LaggedSolver solver;
  relativeResidual(solver, springs(50, 0.5, 1), 1e-8);
  EXPECT_EQ(solver.iterationsFor(1e-8), 0.0);
  relativeResidual(solver, springs(50, 0.5, 2), 1e-4);
  const double foretold = solver.iterationsFor(1e-8);
  const int before = solver.iterations();
  relativeResidual(solver, springs(50, 0.5, 3), 1e-8);
  EXPECT_EQ(solver.factorizations(), 1);
  EXPECT_NEAR(solver.iterations() - before, foretold, 0.3 * foretold);
  solver.forgetPreconditioner();
  relativeResidual(solver, springs(50, 0.5, 3), 1e-2);
  EXPECT_EQ(solver.factorizations(), 2);
}

TEST(LaggedSolver, SaysThatAMatrixIsIndefinite)
{
  LaggedSolver solver;
  const SparseMatrix matrix = -springs(50, 0.5, 1);
  Eigen::VectorXd x;
  EXPECT_FALSE(solver.solve(matrix, Eigen::VectorXd::Ones(matrix.rows()), 1e-3, x));
  EXPECT_LE(relativeResidual(solver, springs(50, 0.5, 1), 1e-8), 1e-8) << "goes on afterwards";
}

TEST(LaggedSolver, LargeSystemsNeedNoFactor)
{
  LaggedSolver solver;
  for (int seed = 0; seed < 3; ++seed)
  {
    const double tolerance = std::pow(10.0, -2 - 2 * seed);
    EXPECT_LE(relativeResidual(solver, springs(320, 0.5, seed), tolerance), 1.001 * tolerance) << seed;
  }
  EXPECT_LE(relativeResidual(solver, springs(330, 0.5, 1), 1e-4), 1.001e-4) << "of another size";
  EXPECT_EQ(solver.factorizations(), 0);
  EXPECT_LT(solver.iterations(), 50);
  EXPECT_TRUE(solver.hasPreconditioner());
  EXPECT_GT(solver.iterationsFor(1e-8), 5.0);
  const SparseMatrix indefinite = -springs(320, 0.5, 1);
  Eigen::VectorXd x;
  EXPECT_FALSE(solver.solve(indefinite, Eigen::VectorXd::Ones(indefinite.rows()), 1e-3, x));
  EXPECT_LE(relativeResidual(solver, springs(320, 0.5, 1), 1e-4), 1.001e-4) << "goes on afterwards";
}

TEST(LaggedSolver, LevelsAreRenewedWhereTheyDoNotServe)
{
  LaggedSolver solver;
  std::vector<int> iterations;
  for (int seed = 0; seed < 5; ++seed)
  {
    const int before = solver.iterations();
    EXPECT_LE(relativeResidual(solver, springs(320, 4.0, seed), 1e-3), 1.001e-3) << seed;
    iterations.push_back(solver.iterations() - before);
  }
  EXPECT_GT(iterations[1], iterations[0] + 10) << "with the levels of the first matrix";
  for (int k = 2; k < 5; ++k)
  {
    EXPECT_LE(iterations[k], iterations[0] + 5) << k;
  }
  EXPECT_EQ(solver.factorizations(), 0);
}

} // namespace
