// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/FaceAreaEnergy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace flattening;

TEST(FaceAreaEnergy, VanishesForASimilarTriangleOfTheTargetArea)
{
  const auto value = FaceAreaEnergy(0.0).value(0.7, 0.7, 0.7, { 3.0, 0.01 });
  EXPECT_NEAR(value.Energy, 0.0, 1e-16);
  // Growing it as it is gains nothing either: the derivatives by both measures of its size cancel.
  EXPECT_NEAR(value.ByArea + value.ByDirichlet, 0.0, 1e-16);
}

TEST(FaceAreaEnergy, IsInfiniteForAFlippedFaceUnlessEpsilonIsPositive)
{
  EXPECT_TRUE(std::isinf(FaceAreaEnergy(0.0).value(-0.1, 1.0, 1.0, { 1.0, 0.0 }).Energy));
  EXPECT_TRUE(std::isinf(FaceAreaEnergy(0.0).value(0.0, 1.0, 1.0, { 1.0, 0.0 }).Energy));
  EXPECT_TRUE(std::isfinite(FaceAreaEnergy(0.1).value(-50.0, 1.0, 50.0, { 1.0, 0.01 }).Energy));
}

// However much shape counts: the logarithms of both its sizes are smoothed alike.
TEST(FaceAreaEnergy, AFaceDoesNotGainByShrinkingToAPoint)
{
  for (const double shape : { 0.01, 0.3, 3.0 })
  {
    for (const double size : { 1e-2, 1e-4, 1e-8, 0.0 })
    {
      EXPECT_GT(FaceAreaEnergy(0.1).value(size, 1.0, size, { 1.0, shape }).Energy, 0.9)
        << shape << " " << size;
    }
  }
}

TEST(FaceAreaEnergy, DerivativesMatchDifferences)
{
  constexpr double target = 0.3;
  constexpr double step = 1e-5;
  for (const auto& [epsilon, shapeLimit] :
    { std::pair(0.0, 1e9), { 0.1, 1e9 }, { 0.0, 1.2 }, { 0.1, 1.2 } })
  {
    const FaceAreaEnergy::Weights weights{ 5.0, 0.02, 3.0, shapeLimit };
    const FaceAreaEnergy energy(epsilon);
    for (const double area : { -0.2, 0.05, 0.3, 0.9 })
    {
      if (epsilon == 0.0 && area < 0.0)
      {
        continue;
      }
      const double dirichlet = std::abs(area) + 0.1;
      const auto at = [&](double a, double q) { return energy.value(a, target, q, weights).Energy; };
      const auto value = energy.value(area, target, dirichlet, weights);
      const double up = at(area + step, dirichlet);
      const double down = at(area - step, dirichlet);
      EXPECT_NEAR(value.ByArea, (up - down) / (2.0 * step), 1e-6 * (1.0 + std::abs(value.ByArea)));
      EXPECT_NEAR(value.ByDirichlet,
        (at(area, dirichlet + step) - at(area, dirichlet - step)) / (2.0 * step),
        1e-6);
      const double second = (up - 2.0 * value.Energy + down) / (step * step);
      EXPECT_GE(value.Curvature, second * (1.0 - 1e-3) - 1e-3);
      if (area > 0.0) // every term is convex by the area there
      {
        EXPECT_NEAR(value.Curvature, second, 1e-3 * second);
      }
    }
  }
}

// Up to the limit the shape's energy is a logarithm, whose derivative is that of the continuation there.
TEST(FaceAreaEnergy, GrowsInProportionBeyondTheShapeLimit)
{
  const FaceAreaEnergy energy(0.0);
  const auto shape = [&energy](double dirichlet) {
    return energy.value(1.0, 1.0, dirichlet, { 1.0, 0.5, 1.0, 3.0 }).Energy;
  };
  EXPECT_DOUBLE_EQ(shape(2.0), 0.5 * std::log(2.0));
  EXPECT_DOUBLE_EQ(shape(3.0), 0.5 * std::log(3.0));
  EXPECT_DOUBLE_EQ(shape(30.0), 0.5 * (std::log(3.0) + 9.0));
}

} // namespace
