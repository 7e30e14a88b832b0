// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/LengthErrors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace flattening;

namespace
{

TEST(LengthErrors, OneScaleTakesAllAway)
{
  const LengthErrors errors = lengthErrors({ { { 4.0, 4.0 }, { 1.0, 2.0 } }, { { 4.0 }, { 3.0 } } });
  EXPECT_EQ(errors.Scale, 0.25);
  EXPECT_EQ(errors.Mean, 0.0);
  EXPECT_EQ(errors.StandardError, 0.0);
  EXPECT_EQ(errors.P95, 0.0);
}

// Ratios 1, 1 and 2: with scale 1 the error of the last is 100 %, with scale 1/2 those of the others
// are 50 % each. By weight of pairs within their sources the first three weigh 1/2, 1/2 and 1.
TEST(LengthErrors, EverySourceCountsTheSame)
{
  const LengthErrors errors = lengthErrors({ { { 1.0, 1.0 }, { 7.0, 7.0 } }, { { 2.0 }, { 0.1 } } });
  EXPECT_EQ(errors.Scale, 0.5);
  EXPECT_DOUBLE_EQ(errors.Mean, 25.0);
  EXPECT_DOUBLE_EQ(errors.StandardError, 25.0) << "means 50 and 0: deviation 35.36 over root 2";
  EXPECT_DOUBLE_EQ(errors.P95, 50.0);
}

TEST(LengthErrors, TheScaleMakesTheMeanLeast)
{
  std::vector<SourceLengths> sources;
  for (int i = 0; i < 5; ++i)
  {
    SourceLengths source;
    for (int j = 0; j < 20; ++j)
    {
      source.Ratios.push_back(0.3 + std::fmod(0.377 * i + 0.619 * j * j, 1.7));
      source.Weights.push_back(0.1 + std::fmod(0.71 * j + 0.3 * i, 1.0));
    }
    sources.push_back(source);
  }
  const auto meanAt = [&sources](double scale)
  {
    double mean = 0.0;
    for (const SourceLengths& source : sources)
    {
      double error = 0.0;
      double weight = 0.0;
      for (std::size_t i = 0; i < source.Ratios.size(); ++i)
      {
        error += source.Weights[i] * std::abs(scale * source.Ratios[i] - 1.0);
        weight += source.Weights[i];
      }
      mean += 100.0 * error / weight / 5.0;
    }
    return mean;
  };
  const LengthErrors errors = lengthErrors(sources);
  EXPECT_NEAR(errors.Mean, meanAt(errors.Scale), 1e-10);
  EXPECT_GT(errors.Mean, 10.0);
  for (double scale = 0.2; scale < 4.0; scale *= 1.001)
  {
    EXPECT_GE(meanAt(scale), errors.Mean - 1e-10) << scale;
  }
}

TEST(LengthErrors, NothingIsZero)
{
  const LengthErrors none = lengthErrors({ {}, {} });
  EXPECT_EQ(none.Scale, 0.0);
  EXPECT_EQ(none.Mean, 0.0);
  const LengthErrors collapsed = lengthErrors({ { { 0.0 }, { 1.0 } }, {} });
  EXPECT_EQ(collapsed.Mean, 100.0) << "a source without pairs does not count";
  EXPECT_EQ(collapsed.StandardError, 0.0);
}

} // namespace
