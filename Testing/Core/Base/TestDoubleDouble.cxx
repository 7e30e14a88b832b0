// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/DoubleDouble.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace flattening;

TEST(DoubleDouble, KeepsTwiceTheDigits)
{
  const DoubleDouble one = 1.0;
  EXPECT_EQ(static_cast<double>(one + 1e-25 - 1.0), 1e-25);
  EXPECT_EQ(static_cast<double>(DoubleDouble(-1e-25) - 1.0 + one), -1e-25);
  // (1 + e)^2 = 1 + 2 e + e^2
  const double e = std::ldexp(1.0, -45);
  const DoubleDouble square = (one + e) * (one + e);
  EXPECT_EQ(static_cast<double>(square - 1.0 - 2.0 * e), e * e);
  EXPECT_EQ(DoubleDouble::product(1.0 + e, 1.0 + e), square);
  EXPECT_EQ(DoubleDouble::sum(1.0, e * e) - e * e, one);
}

TEST(DoubleDouble, SquareRoot)
{
  for (const double value : { 2.0, 1e-30, 3e20 })
  {
    const DoubleDouble root = sqrt(DoubleDouble(value));
    EXPECT_NEAR(static_cast<double>(root * root - value), 0.0, 1e-30 * value) << value;
  }
  EXPECT_EQ(sqrt(DoubleDouble(0.0)), DoubleDouble(0.0));
}

TEST(DoubleDouble, ComparesTheLowPartToo)
{
  const DoubleDouble one = 1.0;
  EXPECT_LT(one, one + 1e-25);
  EXPECT_LT(one - 1e-25, one);
  EXPECT_FALSE(one < one);
  EXPECT_NE(one, one + 1e-25);
}

} // namespace
