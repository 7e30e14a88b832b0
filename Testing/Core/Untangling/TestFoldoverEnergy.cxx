// SPDX-License-Identifier: GPL-3.0-or-later
/// The energy of one triangle and the kernel of one star, by hand.
#include "Support/RandomNumbers.h"
#include "Untangling/FoldoverEnergy.h"
#include "Untangling/StarKernel.h"

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
  const Eigen::Matrix2d turn = (Eigen::Matrix2d() << 0.0, -1.0, 1.0, 0.0).finished();
  EXPECT_NEAR(energy.value(cornersOf(turn), 0.0), 3.0, 1e-14) << "least: a turn";
  EXPECT_NEAR(energy.value(cornersOf(3.0 * turn), 0.0), 2.0 + 0.5 * 82.0 / 9.0, 1e-13);
  const Eigen::Matrix2d stretch = Eigen::Vector2d(2.0, 0.5).asDiagonal();
  EXPECT_NEAR(energy.value(cornersOf(stretch), 0.0), 4.25 + 1.0, 1e-13);
  EXPECT_NEAR(energy.areaRatio(cornersOf(3.0 * turn)), 9.0, 1e-13);

  const Eigen::Matrix2d mirror = Eigen::Vector2d(-1.0, 1.0).asDiagonal();
  EXPECT_EQ(energy.areaRatio(cornersOf(mirror)), -1.0);
  EXPECT_TRUE(std::isinf(energy.value(cornersOf(mirror), 0.0)));
  // chi(-1) = epsilon^2 / 4 to first order.
  EXPECT_NEAR(energy.value(cornersOf(mirror), 1e-6) * 1e-12, 3.0 * 4.0, 1e-9);
}

TEST(FoldoverEnergy, DerivativesAreThoseOfTheValue)
{
  RandomNumbers random(11);
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
    // The convex one is never below the true one, and is it where that is convex.
    using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>;
    const double size = hessian.norm();
    EXPECT_GE(Solver(exact.Hessian - hessian).eigenvalues().minCoeff(), -1e-5 * size) << round;
    EXPECT_GE(Solver(exact.Hessian).eigenvalues().minCoeff(), -1e-12 * exact.Hessian.norm()) << round;
  }
  const FoldoverEnergy energy(Target, 0.5);
  const FoldoverEnergy::Corners best = cornersOf(Eigen::Matrix2d::Identity());
  EXPECT_LT(energy.derivatives(best, 0.0).Gradient.norm(), 1e-13);
}

std::vector<OppositeSide> squareStar(double altitude)
{
  const Eigen::Vector2d corners[] = { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } };
  std::vector<OppositeSide> sides;
  for (int k = 0; k < 4; ++k)
  {
    sides.push_back({ corners[k], corners[(k + 1) % 4], altitude });
  }
  return sides;
}

TEST(StarKernel, NearestPlaceInASquare)
{
  const std::vector<OppositeSide> star = squareStar(0.25);
  const auto inside = nearestInKernel({ 1.5, 0.5 }, star);
  ASSERT_TRUE(inside);
  EXPECT_EQ(*inside, Eigen::Vector2d(1.5, 0.5)) << "it is there already";
  const auto beyondASide = nearestInKernel({ 1.5, -3.0 }, star);
  ASSERT_TRUE(beyondASide);
  EXPECT_LT((*beyondASide - Eigen::Vector2d(1.5, 0.25)).norm(), 1e-15);
  const auto beyondACorner = nearestInKernel({ 5.0, 7.0 }, star);
  ASSERT_TRUE(beyondACorner);
  EXPECT_LT((*beyondACorner - Eigen::Vector2d(1.75, 1.75)).norm(), 1e-15);
  EXPECT_FALSE(nearestInKernel({ 1.0, 1.0 }, squareStar(1.1))) << "no room for that";
}

// Against a fine grid of the places that have the altitudes.
TEST(StarKernel, NoPlaceOfAGridIsNearer)
{
  RandomNumbers random(4);
  int found = 0;
  for (int round = 0; round < 100; ++round)
  {
    std::vector<OppositeSide> star;
    const int degree = random.integer(3, 9);
    const double altitude = random.real(0.02, 0.5);
    std::vector<Eigen::Vector2d> link;
    for (int k = 0; k < degree; ++k)
    {
      const double angle = 2.0 * EIGEN_PI * (k + random.real(0.0, 0.9)) / degree;
      link.emplace_back(random.real(0.3, 1.0) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    for (int k = 0; k < degree; ++k)
    {
      star.push_back({ link[k], link[(k + 1) % degree], altitude });
    }
    const Eigen::Vector2d position = random.point(-1.0, 1.0).head<2>().transpose();
    const auto nearest = nearestInKernel(position, star);
    const auto excess = [&](const Eigen::Vector2d& x)
    {
      double least = HUGE_VAL;
      for (const OppositeSide& side : star)
      {
        const Eigen::Vector2d along = (side.Second - side.First).normalized();
        const Eigen::Vector2d from = x - side.First;
        least = std::min(least, along.x() * from.y() - along.y() * from.x() - side.Altitude);
      }
      return least;
    };
    double nearestOnGrid = HUGE_VAL;
    for (double x = -1.0; x <= 1.0; x += 0.01)
    {
      for (double y = -1.0; y <= 1.0; y += 0.01)
      {
        if (excess({ x, y }) >= 0.0)
        {
          nearestOnGrid = std::min(nearestOnGrid, (Eigen::Vector2d(x, y) - position).norm());
        }
      }
    }
    if (nearest)
    {
      ++found;
      EXPECT_GE(excess(*nearest), -1e-12) << round;
      EXPECT_LE((*nearest - position).norm(), nearestOnGrid + 1e-12) << round;
    }
    else
    {
      EXPECT_TRUE(std::isinf(nearestOnGrid)) << round;
    }
  }
  EXPECT_GT(found, 30);
  EXPECT_LT(found, 100);
}

} // namespace
