// SPDX-License-Identifier: GPL-3.0-or-later
/// The kernel of one star, against values worked out by hand and a grid of points.
#include "Support/RandomNumbers.h"
#include "Untangling/VertexUntangling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace flattening;
using flattening::samples::RandomNumbers;

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

TEST(VertexUntangling, NearestPointInTheKernelOfASquare)
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

// Against a fine grid of the points that have the altitudes.
TEST(VertexUntangling, NoPointOfAGridIsNearer)
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
