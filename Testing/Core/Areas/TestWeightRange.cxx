// SPDX-License-Identifier: GPL-3.0-or-later
// Area weights from 1e-3 to 1e3, and beyond what doubles resolve.
#include "AnalyticSurfaces.h"
#include "Areas/AreaPreservingDisk.h"
#include "Areas/TargetAreas.h"
#include "Base/Errors.h"
#include "Conformal/ConformalDisk.h"
#include "Mesh/FaceOrientation.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using samples::contains;
using samples::messageOf;
using samples::Pi;

constexpr int Rest = -1;
constexpr int Between = -2;

// Round regions side by side on a bump, each with a weight of its own. Between a region and the rest the
// weight's logarithm runs smoothly over @p edge.
struct WeightedRegions
{
  WeightedRegions(int vertexCount, std::vector<double> factors, double radius, double edge)
    : Mesh(sunflowerMesh(gaussianBump(1.0, 0.3), vertexCount).Mesh)
    , Conformal(conformalDiskMap(Mesh).Positions)
    , Factors(std::move(factors))
    , Weights(Eigen::VectorXd::Ones(Mesh.vertexCount()))
    , RegionOf(Mesh.vertexCount(), Rest)
  {
    for (int v = 0; v < this->Mesh.vertexCount(); ++v)
    {
      for (std::size_t k = 0; k < this->Factors.size(); ++k)
      {
        const double angle = 2.0 * Pi * k / this->Factors.size();
        const Eigen::RowVector2d centre(0.65 * std::cos(angle), 0.65 * std::sin(angle));
        const double distance = (this->Mesh.Vertices.row(v).head<2>() - centre).norm();
        if (distance < radius + edge)
        {
          const double t = distance <= radius ? 0.0 : (distance - radius) / edge;
          this->Weights[v] = std::pow(this->Factors[k], 1.0 - t * t * (3.0 - 2.0 * t));
          this->RegionOf[v] = distance <= radius ? static_cast<int>(k) : Between;
        }
      }
    }
  }

  // How many times as much of the rest's area per area on the surface a region has, @p flat over
  // @p surface by @p regionOf, over its factor.
  std::vector<double> gains(const Eigen::VectorXd& flat,
    const Eigen::VectorXd& surface,
    const std::vector<int>& regionOf) const
  {
    std::vector<double> flatSums(this->Factors.size() + 1, 0.0);
    std::vector<double> surfaceSums(this->Factors.size() + 1, 0.0);
    for (std::size_t i = 0; i < regionOf.size(); ++i)
    {
      if (regionOf[i] != Between)
      {
        flatSums[regionOf[i] + 1] += flat[static_cast<Eigen::Index>(i)];
        surfaceSums[regionOf[i] + 1] += surface[static_cast<Eigen::Index>(i)];
      }
    }
    std::vector<double> gains;
    for (std::size_t k = 0; k < this->Factors.size(); ++k)
    {
      gains.push_back(
        flatSums[k + 1] / surfaceSums[k + 1] / (flatSums[0] / surfaceSums[0]) / this->Factors[k]);
    }
    return gains;
  }

  std::vector<double> cellGains(const AreaPreservingMap& map) const
  {
    const Eigen::VectorXd surface = vertexAreas(this->Mesh);
    return this->gains(map.CellAreas, surface, this->RegionOf);
  }

  // The faces with all corners in the region.
  std::vector<double> faceGains(const AreaPreservingMap& map) const
  {
    return this->gains(signedFaceAreas(map.Positions, this->Mesh.Faces),
      faceAreas(this->Mesh.Vertices, this->Mesh.Faces),
      this->regionOfFaces());
  }

  // The share of the faces of the first region whose areas are within @p tolerance of their targets.
  double shareOfRightFaces(const AreaPreservingMap& map, double tolerance) const
  {
    const Eigen::VectorXd flat = signedFaceAreas(map.Positions, this->Mesh.Faces);
    const Eigen::VectorXd targets = faceTargets(this->Mesh, this->Weights);
    const std::vector<int> regionOf = this->regionOfFaces();
    int count = 0;
    int right = 0;
    for (int f = 0; f < this->Mesh.faceCount(); ++f)
    {
      const double ratio = flat[f] / flat.sum() * targets.sum() / targets[f];
      count += regionOf[f] == 0 ? 1 : 0;
      right += regionOf[f] == 0 && std::abs(ratio - 1.0) <= tolerance ? 1 : 0;
    }
    return static_cast<double>(right) / count;
  }

  std::vector<int> regionOfFaces() const
  {
    std::vector<int> regionOf(this->Mesh.faceCount());
    for (int f = 0; f < this->Mesh.faceCount(); ++f)
    {
      const auto corner = [&](int k) { return this->RegionOf[this->Mesh.Faces(f, k)]; };
      regionOf[f] = corner(0) == corner(1) && corner(1) == corner(2) ? corner(0) : Between;
    }
    return regionOf;
  }

  AreaPreservingMap map(bool refined) const
  {
    AreaPreservingOptions options;
    options.RefineFaces = refined;
    return areaPreservingDiskMap(this->Mesh, this->Conformal, this->Weights, options).Map;
  }

  TriangleMesh Mesh;
  Points2 Conformal;
  std::vector<double> Factors;
  Eigen::VectorXd Weights;
  std::vector<int> RegionOf; // per vertex
};

void expectOnes(const std::vector<double>& gains, double tolerance)
{
  for (const double gain : gains)
  {
    std::cout << gain - 1.0 << " ";
    EXPECT_NEAR(gain, 1.0, tolerance);
  }
  std::cout << "\n";
}

const std::vector<double> SixDecades{ 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1000.0 };

TEST(WeightRange, CellsOfSixDecadesInOneMeshAreLinear)
{
  for (const double edge : { 0.0, 0.16 })
  {
    const WeightedRegions regions(5000, SixDecades, 0.12, edge);
    const AreaPreservingMap map = regions.map(false);
    EXPECT_LE(map.MaxCellError, 1e-6);
    expectOnes(regions.cellGains(map), 1e-6);
  }
}

// Where the weight has a dozen triangles to change in. Beside a region of 1000 the faces of a region
// of 0.001 have a 20,000th of the mean area. From one transport they began 90,000 times as long as wide,
// and with 18,500 vertices the region ended with 25 times its area.
TEST(WeightRange, FacesOfManyDecadesInOneMeshAreLinear)
{
  for (const int vertexCount : { 16000, 18500 })
  {
    const WeightedRegions regions(vertexCount, SixDecades, 0.12, 0.16);
    const AreaPreservingMap map = regions.map(true);
    EXPECT_TRUE(map.Bijective);
    expectOnes(regions.cellGains(map), 1e-6);
    expectOnes(regions.faceGains(map), 0.02);
  }
}

class WeightRangeOf : public testing::TestWithParam<double>
{
};

// The transport of groups of vertices had stopped at 1e3, its cells all but vanished.
TEST_P(WeightRangeOf, OneRegionIsLinear)
{
  const WeightedRegions regions(8000, { GetParam() }, 0.15, 0.25);
  const AreaPreservingMap map = regions.map(true);
  EXPECT_TRUE(map.Bijective);
  expectOnes(regions.cellGains(map), 1e-6);
  expectOnes(regions.faceGains(map), 0.01);
}

INSTANTIATE_TEST_SUITE_P(,
  WeightRangeOf,
  testing::Values(1e-3, 1e-2, 0.1, 10.0, 100.0, 1000.0),
  [](const testing::TestParamInfo<double>& info)
  {
    const int decades = static_cast<int>(std::lround(std::log10(info.param)));
    return (decades < 0 ? "OverTenTo" : "TenTo") + std::to_string(std::abs(decades));
  });

// While faces counted by their targets, the region of 0.001 had 0.4 % too little area.
TEST(WeightRange, RegionsWithASharpEdgeAreLinear)
{
  for (const double factor : { 1e-3, 0.1, 1000.0 })
  {
    const WeightedRegions regions(10000, { factor }, 0.2, 0.0);
    const AreaPreservingMap map = regions.map(true);
    EXPECT_TRUE(map.Bijective);
    expectOnes(regions.cellGains(map), 1e-6);
    expectOnes(regions.faceGains(map), 0.002);
  }
}

TEST(WeightRange, SingleFacesOfASmallEnlargedRegionAreRight)
{
  for (const double factor : { 4.0, 8.0 })
  {
    const WeightedRegions regions(20000, { factor }, 0.05, 0.0);
    const double share = regions.shareOfRightFaces(regions.map(true), 0.02);
    std::cout << share << "\n";
    EXPECT_GE(share, 0.97) << factor;
  }
}

TEST(WeightRange, BelowDoublePrecisionIsRefused)
{
  for (const double factor : { 1e-14, 1e15, 1e-200, 1e200, 1e308, std::numeric_limits<double>::min() })
  {
    const WeightedRegions regions(2000, { factor }, 0.2, 0.0);
    for (const bool refined : { false, true })
    {
      const std::string message = messageOf<InvalidInput>([&] { regions.map(refined); });
      EXPECT_TRUE(contains(message, "below what double precision resolves"))
        << factor << ": " << message;
      EXPECT_TRUE(contains(message, "bring the weights nearer together")) << message;
    }
  }
}

TEST(WeightRange, MoreThanTheRefinementReachesIsRefused)
{
  const WeightedRegions regions(300, { 2e-7 }, 0.2, 0.0);
  const std::string message = messageOf<InvalidInput>([&] { regions.map(true); });
  EXPECT_TRUE(contains(message, "the area weights run from 2e-07 to 1")) << message;
  EXPECT_NO_THROW(regions.map(false));
}

// A hill whose top has 100 times the weight: one of the steps to it fails and is made again in halves,
// on the coarse mesh the first one and on the other one the last.
TEST(WeightRange, ProgressGrowsWhereAStepIsMadeAgain)
{
  for (const int n : { 14, 18 })
  {
    const TriangleMesh mesh = samples::liftedGrid(n,
      [](double x, double y)
      {
        const Eigen::Vector2d place(2.0 * x - 1.0, 2.0 * y - 1.0);
        return Eigen::Vector3d(place.x(), place.y(), 0.8 * std::exp(-4.0 * place.squaredNorm()));
      });
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(mesh.vertexCount());
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      weights[v] = mesh.Vertices.row(v).head<2>().squaredNorm() < 0.15 ? 100.0 : 1.0;
    }
    std::vector<double> fractions;
    areaPreservingDiskMap(mesh,
      conformalDiskMap(mesh).Positions,
      weights,
      {},
      [&](double fraction, const char*)
      {
        fractions.push_back(fraction);
        return true;
      });
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end())) << n;
    EXPECT_GT(fractions.back(), 0.9) << n;
    EXPECT_LE(fractions.back(), 1.0) << n;
  }
}

// Weights count relative to each other: alone their common factor says nothing.
TEST(WeightRange, ACommonFactorChangesNothing)
{
  WeightedRegions regions(1000, { 4.0 }, 0.2, 0.0);
  const AreaPreservingMap expected = regions.map(true);
  for (const double factor : { 0x1p-1000, 0x1p+900 })
  {
    regions.Weights *= factor;
    const AreaPreservingMap map = regions.map(true);
    EXPECT_LT((map.Positions - expected.Positions).cwiseAbs().maxCoeff(), 1e-12) << factor;
    regions.Weights /= factor;
  }
}

} // namespace
