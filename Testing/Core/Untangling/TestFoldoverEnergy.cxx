// SPDX-License-Identifier: GPL-3.0-or-later
/// The energy of one triangle, against values worked out by hand and finite differences.
#include "Support/RandomNumbers.h"
#include "Untangling/FoldoverEnergy.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace
{

using namespace flattening;
using flattening::samples::RandomNumbers;

const TargetTriangle Target{ { 1.0, 0.0 }, { 0.25, 0.75 } };

FoldoverEnergy::Corners cornersOf(const Eigen::Matrix2d& map)
{
  FoldoverEnergy::Corners corners;
  corners.row(0) << 3.0, -2.0;
  corners.row(1) = corners.row(0) + (map * Target.Second).transpose();
  corners.row(2) = corners.row(0) + (map * Target.Third).transpose();
  return corners;
}

TEST(FoldoverEnergy, KnownValues)
{
  const FoldoverEnergy energy(Target, 0.5);
  const Eigen::Matrix2d rotation = (Eigen::Matrix2d() << 0.0, -1.0, 1.0, 0.0).finished();
  EXPECT_NEAR(energy.value(cornersOf(rotation), 0.0), 3.0, 1e-14) << "the least value: a rotation";
  EXPECT_NEAR(energy.value(cornersOf(3.0 * rotation), 0.0), 2.0 + 0.5 * 82.0 / 9.0, 1e-13);
  const Eigen::Matrix2d stretch = Eigen::Vector2d(2.0, 0.5).asDiagonal();
  EXPECT_NEAR(energy.value(cornersOf(stretch), 0.0), 4.25 + 1.0, 1e-13);
  EXPECT_NEAR(energy.areaRatio(cornersOf(3.0 * rotation)), 9.0, 1e-13);

  const Eigen::Matrix2d mirror = Eigen::Vector2d(-1.0, 1.0).asDiagonal();
  EXPECT_EQ(energy.areaRatio(cornersOf(mirror)), -1.0);
  EXPECT_TRUE(std::isinf(energy.value(cornersOf(mirror), 0.0)));
  // chi(-1) = epsilon^2 / 4 to first order.
  EXPECT_NEAR(energy.value(cornersOf(mirror), 1e-6) * 1e-12, 3.0 * 4.0, 1e-9);
}

TEST(FoldoverEnergy, DerivativesAreThoseOfTheValue)
{
  RandomNumbers random(11);
  int alreadyConvex = 0;
  for (int round = 0; round < 200; ++round)
  {
    const FoldoverEnergy energy(Target, random.real(0.0, 2.0));
    FoldoverEnergy::Corners corners;
    for (int k = 0; k < 3; ++k)
    {
      corners.row(k) = random.point(-1.0, 1.0).head<2>();
    }
    const double epsilon = random.real(0.2, 1.0);
    const FoldoverEnergy::Derivatives exact = energy.derivatives(corners, epsilon);
    const auto shifted = [&](int a, double step)
    {
      FoldoverEnergy::Corners result = corners;
      result(a / 2, a % 2) += step;
      return result;
    };
    Eigen::Matrix<double, 6, 6> hessian;
    constexpr double step = 1e-5;
    for (int a = 0; a < 6; ++a)
    {
      const double slope =
        (energy.value(shifted(a, step), epsilon) - energy.value(shifted(a, -step), epsilon)) /
        (2.0 * step);
      EXPECT_NEAR(exact.Gradient[a], slope, 1e-6 * (1.0 + exact.Gradient.norm())) << round;
      hessian.col(a) = (energy.derivatives(shifted(a, step), epsilon).Gradient -
                         energy.derivatives(shifted(a, -step), epsilon).Gradient) /
                       (2.0 * step);
    }
    // The semidefinite Hessian is never below the true one.
    using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>;
    const double size = hessian.norm();
    EXPECT_GE(Solver(exact.Hessian - hessian).eigenvalues().minCoeff(), -1e-5 * size) << round;
    EXPECT_GE(Solver(exact.Hessian).eigenvalues().minCoeff(), -1e-12 * exact.Hessian.norm()) << round;
    if (Solver(hessian).eigenvalues().minCoeff() > -1e-7 * size)
    {
      ++alreadyConvex;
      EXPECT_LT((exact.Hessian - hessian).norm(), 1e-5 * size) << round;
    }
  }
  EXPECT_GT(alreadyConvex, 20);
  const FoldoverEnergy energy(Target, 0.5);
  const FoldoverEnergy::Corners best = cornersOf(Eigen::Matrix2d::Identity());
  EXPECT_LT(energy.derivatives(best, 0.0).Gradient.norm(), 1e-13);
}

} // namespace
