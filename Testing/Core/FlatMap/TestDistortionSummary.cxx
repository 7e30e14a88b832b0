// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/DistortionSummary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace
{

using namespace flattening;

// Faces of the given area ratios, else undistorted, all of the same surface area.
FaceDistortion withAreaRatios(const Eigen::VectorXd& ratios, double surfaceArea)
{
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(ratios.size());
  FaceDistortion d;
  d.SurfaceArea = d.TargetArea = surfaceArea * ones;
  d.AreaRatio = d.FlatArea = ratios;
  d.TotalTargetArea = d.TargetArea.sum();
  d.TotalFlatArea = d.FlatArea.sum();
  d.AreaDistortion = -ratios.array().log();
  d.AngleDistortion = d.BeltramiMagnitude = d.AngleError = 0.0 * ones;
  d.StretchL2 = ones;
  d.SymmetricDirichlet = 4.0 * ones;
  d.Flipped = d.SurfaceDegenerate = d.FlatDegenerate = std::vector<char>(ratios.size(), 0);
  return d;
}

// 200 faces whose area errors are 0.05, 0.15, ... 9.95 percent, once too small and once too large.
FaceDistortion withKnownErrors()
{
  Eigen::VectorXd ratios(200);
  for (int k = 0; k < 100; ++k)
  {
    ratios[k] = 1.0 - (k + 0.5) / 1000.0;
    ratios[100 + k] = 1.0 + (k + 0.5) / 1000.0;
  }
  return withAreaRatios(ratios, 3.0);
}

TEST(DistortionSummary, StatisticsOfKnownErrors)
{
  const DistortionSummary total = summariseDistortion(withKnownErrors());
  EXPECT_EQ(total.Faces, 200);
  EXPECT_EQ(total.FlippedFaces, 0);
  EXPECT_EQ(total.DegenerateFaces, 0);
  EXPECT_NEAR(total.SurfaceArea, 600.0, 1e-12);
  EXPECT_NEAR(total.FlatArea, 200.0, 1e-12);
  EXPECT_NEAR(total.AreaErrorPercent, 0.0, 1e-12);
  EXPECT_NEAR(total.FacesWithin2Percent, 20.0, 1e-12);
  EXPECT_NEAR(total.RootMeanSquareStretch, 1.0, 1e-15);
  const MeasureStatistics& error = total[Measure::AreaError];
  EXPECT_NEAR(error.Mean, 5.0, 1e-12);
  EXPECT_NEAR(error.AreaWeightedMean, 5.0, 1e-12);
  EXPECT_NEAR(error.P95, 9.45, 1e-12);
  EXPECT_NEAR(error.P99, 9.85, 1e-12);
  EXPECT_NEAR(error.Max, 9.95, 1e-12);
  EXPECT_NEAR(total[Measure::AreaDistortion].Max, -std::log(1.0 - 0.0995), 1e-12);
  EXPECT_NEAR(total[Measure::SymmetricDirichlet].Mean, 4.0, 1e-14);
}

TEST(DistortionSummary, ARegionIsComparedByItsShares)
{
  std::vector<int> tooLarge(100);
  std::iota(tooLarge.begin(), tooLarge.end(), 100);
  const DistortionSummary region = summariseDistortion(withKnownErrors(), tooLarge);
  EXPECT_EQ(region.Faces, 100);
  EXPECT_NEAR(region.SurfaceArea, 300.0, 1e-12);
  EXPECT_NEAR(region.FlatArea, 105.0, 1e-12);
  EXPECT_NEAR(region.AreaErrorPercent, 5.0, 1e-12);
  // One face 1 percent too large, one 1 percent too small: the region is right, the faces are not.
  const DistortionSummary cancelling = summariseDistortion(withKnownErrors(), { 10, 110 });
  EXPECT_NEAR(cancelling.AreaErrorPercent, 0.0, 1e-12);
  EXPECT_NEAR(cancelling[Measure::AreaError].Mean, 1.05, 1e-12);
}

TEST(DistortionSummary, AFlippedFaceIsNotWithin2Percent)
{
  FaceDistortion d = withKnownErrors();
  d.Flipped[3] = 1;
  EXPECT_EQ(summariseDistortion(d).FlippedFaces, 1);
  EXPECT_NEAR(summariseDistortion(d).FacesWithin2Percent, 19.5, 1e-12);
}

TEST(DistortionSummary, LargeFacesCountMoreInAreaWeightedMeans)
{
  TriangleMesh surface;
  surface.Faces.resize(2, 3);
  surface.Faces << 0, 1, 2, 3, 4, 5;
  surface.Vertices.resize(6, 3);
  surface.Vertices << 0, 0, 0, 2, 0, 0, 0, 2, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0; // areas 2 and 1/2
  Points2 flat(6, 2);
  flat << 0, 0, 1, 0, 0, 1, 5, 0, 6, 0, 5, 1; // areas 1/2 and 1/2: ratios 5/8 and 5/2
  const DistortionSummary s = summariseDistortion(measureDistortion(surface, flat));
  EXPECT_NEAR(s[Measure::AreaError].Mean, 0.5 * (37.5 + 150.0), 1e-11);
  EXPECT_NEAR(s[Measure::AreaError].AreaWeightedMean, 0.8 * 37.5 + 0.2 * 150.0, 1e-11);
  // Gamma = gamma, so the squared stretches are 1.6 and 0.4.
  EXPECT_NEAR(s.RootMeanSquareStretch, std::sqrt(0.8 * 1.6 + 0.2 * 0.4), 1e-13);
}

TEST(DistortionSummary, DegenerateFacesAreCountedAndLeftOut)
{
  // Face 0 is sound, 1 has no area on the surface, 2 none in the flat.
  FaceDistortion d = withAreaRatios(Eigen::Vector3d(1.5, 1.0, 0.0), 1.0);
  d.SurfaceArea[1] = d.TargetArea[1] = 0.0;
  d.AreaDistortion = d.AngleDistortion = Eigen::Vector3d(0.7, 0.0, 0.0);
  d.SurfaceDegenerate[1] = 1;
  d.FlatDegenerate[2] = d.Flipped[2] = 1;
  const DistortionSummary s = summariseDistortion(d);
  EXPECT_EQ(s.Faces, 3);
  EXPECT_EQ(s.DegenerateFaces, 2);
  EXPECT_EQ(s.FlippedFaces, 1);
  EXPECT_EQ(s.FacesWithin2Percent, 0.0);
  EXPECT_NEAR(s[Measure::AreaError].Mean, 75.0, 1e-12); // 50 and 100 percent
  EXPECT_NEAR(s[Measure::AreaError].Max, 100.0, 1e-12);
  EXPECT_NEAR(s[Measure::AngleDistortion].Mean, 0.7, 1e-15);
}

TEST(DistortionSummary, NoFaces)
{
  const DistortionSummary s = summariseDistortion(withKnownErrors(), {});
  EXPECT_EQ(s.Faces, 0);
  EXPECT_EQ(s.AreaErrorPercent, 0.0);
  EXPECT_EQ(s[Measure::AreaError].Max, 0.0);
}

} // namespace
