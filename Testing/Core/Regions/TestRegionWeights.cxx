// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Base/Errors.h"
#include "Regions/RegionWeights.h"
#include "Support/SampleSurfaces.h"

#include <cmath>
#include <limits>

namespace
{

using namespace flattening;
using namespace flattening::samples;

TriangleMesh sheet()
{
  return analytic::sunflowerMesh(analytic::flatDisk(), 4000).Mesh;
}

Eigen::VectorXd areasOf(const TriangleMesh& mesh)
{
  return vertexAreas(mesh);
}

WeightedRegion ball(const TriangleMesh& mesh, double x, double radius, double factor)
{
  WeightedRegion region{ "the ball", std::vector<char>(mesh.vertexCount()), factor };
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    region.Inside[v] = (mesh.Vertices.row(v) - Eigen::RowVector3d(x, 0, 0)).norm() <= radius;
  }
  return region;
}

TEST(RegionWeights, SharpRegionsHaveTheirFactorsAndTheRestOne)
{
  const TriangleMesh mesh = sheet();
  const WeightedRegion left = ball(mesh, -0.5, 0.2, 4.0);
  const WeightedRegion right = ball(mesh, 0.5, 0.3, 0.25);
  const RegionWeights result =
    regionWeights(mesh, areasOf(mesh), { left, right }, FactorMeaning::RelativeToRest, 0.0);
  EXPECT_EQ(result.RestWeight, 1.0);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_EQ(result.Weights[v], left.Inside[v] ? 4.0 : right.Inside[v] ? 0.25 : 1.0);
  }
}

TEST(RegionWeights, MagnifiedRegionsTakeTheirRoomFromTheRest)
{
  const TriangleMesh mesh = sheet();
  const Eigen::VectorXd areas = areasOf(mesh);
  for (const double width : { 0.0, 0.2 })
  {
    SCOPED_TRACE(width);
    const WeightedRegion region = ball(mesh, 0.1, 0.3, 6.0); // 9 % of the area: 54 % on the map
    const RegionWeights result =
      regionWeights(mesh, areas, { region }, FactorMeaning::Magnification, width);
    EXPECT_NEAR(result.Weights.dot(areas) / areas.sum(), 1.0, 1e-12);
    double inside = 0.0;
    double factored = 0.0;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      inside += region.Inside[v] ? areas[v] : 0.0;
      factored += region.Inside[v] ? areas[v] * result.Weights[v] : 0.0;
    }
    EXPECT_NEAR(factored / inside, 6.0, 1e-12);
    if (width == 0.0)
    {
      const double share = inside / areas.sum();
      EXPECT_NEAR(result.RestWeight, (1.0 - 6.0 * share) / (1.0 - share), 1e-12);
    }
    const MagnificationRange range = magnificationRange(areas, result.Weights);
    EXPECT_NEAR(range.Greatest, 6.0, 1e-12);
    EXPECT_NEAR(range.Smallest, result.RestWeight, 1e-12);
  }
}

// On a flat disk the distance from a region is that in the plane.
TEST(RegionWeights, SoftEdgesFadeOverTheirWidth)
{
  const TriangleMesh mesh = sheet();
  const double radius = 0.4;
  const double width = 0.4;
  const RegionWeights result = regionWeights(
    mesh, areasOf(mesh), { ball(mesh, 0.0, radius, 5.0) }, FactorMeaning::RelativeToRest, width);
  double worst = 0.0;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double t = 1.0 - (mesh.Vertices.row(v).norm() - radius) / width;
    const double share = t >= 1.0 ? 1.0 : t <= 0.0 ? 0.0 : t * t * (3.0 - 2.0 * t);
    worst = std::max(worst, std::abs(result.Weights[v] - (1.0 + 4.0 * share)) / 4.0);
    if (t >= 1.0)
    {
      EXPECT_EQ(result.Weights[v], 5.0);
    }
  }
  // Half an edge, 0.014, between the region's outermost points and the circle; slope at most 1.5 /
  // width.
  EXPECT_LT(worst, 0.014 * 1.5 / width + 0.02);
}

TEST(RegionWeights, SoftEdgesDoNotSeePointsWithoutAFace)
{
  const TriangleMesh mesh = sheet();
  TriangleMesh more = mesh; // with points before, after and upon the others
  more.Vertices.resize(mesh.vertexCount() + 3, 3);
  more.Vertices << 0.0, 0.0, 9.0, mesh.Vertices.row(7), mesh.Vertices, 5.0, 5.0, 5.0;
  more.Faces.array() += 2;
  const auto weightsOf = [](const TriangleMesh& surface)
  {
    return regionWeights(
      surface, areasOf(surface), { ball(surface, 0.0, 0.4, 5.0) }, FactorMeaning::RelativeToRest, 0.4)
      .Weights;
  };
  EXPECT_EQ(weightsOf(more).segment(2, mesh.vertexCount()), weightsOf(mesh));
}

// Over the edge of a fold the distance runs along the surface: two parallel sheets a hair apart.
TEST(RegionWeights, SoftEdgesDoNotJumpToAnotherFold)
{
  TriangleMesh mesh = cylinder(400, 60, 1.0);
  mesh.Vertices.col(1) *= 0.02; // flattened: its two sides are 0.04 apart, but 1 around
  WeightedRegion region{ "the side", std::vector<char>(mesh.vertexCount()), 3.0 };
  int opposite = -1;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Eigen::RowVector3d x = mesh.Vertices.row(v) - Eigen::RowVector3d(0, 0.02, 0.5);
    region.Inside[v] = x.norm() < 0.1 && mesh.Vertices(v, 1) > 0.0;
    opposite = (mesh.Vertices.row(v) - Eigen::RowVector3d(0, -0.02, 0.5)).norm() < 0.02 ? v : opposite;
  }
  ASSERT_GE(opposite, 0);
  const RegionWeights result =
    regionWeights(mesh, areasOf(mesh), { region }, FactorMeaning::RelativeToRest, 0.5);
  EXPECT_EQ(result.Weights[opposite], 1.0);
}

TEST(RegionWeights, OverlappingEdgesStayBetweenTheFactors)
{
  const TriangleMesh mesh = sheet();
  const WeightedRegion left = ball(mesh, -0.3, 0.2, 4.0);
  const WeightedRegion right = ball(mesh, 0.3, 0.2, 8.0);
  const Eigen::VectorXd weights =
    regionWeights(mesh, areasOf(mesh), { left, right }, FactorMeaning::RelativeToRest, 0.6).Weights;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_GE(weights[v], 1.0);
    EXPECT_LE(weights[v], 8.0);
    EXPECT_TRUE(!left.Inside[v] || weights[v] == 4.0);
    EXPECT_TRUE(!right.Inside[v] || weights[v] == 8.0);
  }
}

TEST(RegionWeights, LabelsOfFacesGoToTheVerticesThatTheyCoverMost)
{
  // A strip of three squares; label 2 covers the middle one.
  const TriangleMesh strip = meshOf({ { 0, 0, 0 },
                                      { 1, 0, 0 },
                                      { 5, 0, 0 },
                                      { 6, 0, 0 },
                                      { 0, 1, 0 },
                                      { 1, 1, 0 },
                                      { 5, 1, 0 },
                                      { 6, 1, 0 },
                                      { 9, 9, 9 } },
    { { 0, 1, 5 }, { 0, 5, 4 }, { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 } });
  EXPECT_EQ(vertexLabels(strip, { 1, 1, 2, 2, 3, 3 }, -7),
    (std::vector<long long>{ 1, 2, 2, 3, 1, 2, 2, 3, -7 }));
}

TEST(RegionWeights, RefusesWhatMakesNoSense)
{
  const TriangleMesh mesh = sheet();
  const Eigen::VectorXd areas = areasOf(mesh);
  const auto expectInvalid =
    [&](WeightedRegion region, FactorMeaning meaning, double width, const std::string& words)
  {
    SCOPED_TRACE(words);
    try
    {
      regionWeights(mesh, areas, { std::move(region) }, meaning, width);
      ADD_FAILURE() << "no exception";
    }
    catch (const InvalidInput& error)
    {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto relative = FactorMeaning::RelativeToRest;
  for (const double factor : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    expectInvalid(ball(mesh, 0, 0.2, factor), relative, 0.0, "must be positive numbers");
  }
  expectInvalid(ball(mesh, 5, 0.2, 2), relative, 0.0, "has no point of the surface");
  expectInvalid(ball(mesh, 0, 2.0, 2), relative, 0.0, "cover the whole surface");
  expectInvalid(ball(mesh, 0, 2.0, 2), FactorMeaning::Magnification, 0.0, "cover");
  expectInvalid(ball(mesh, 0, 0.5, 4.1), FactorMeaning::Magnification, 0.0, "would take 10");
  expectInvalid(ball(mesh, 0, 0.5, 2), relative, -1.0, "width");
  expectInvalid(ball(mesh, 0, 0.5, 2), relative, nan, "width");
}

TEST(RegionWeights, SoftEdgesNeedOnePiece)
{
  const TriangleMesh two = both(sheet(), moved(sheet(), 5, 0, 0));
  EXPECT_NO_THROW(
    regionWeights(two, areasOf(two), { ball(two, 0, 0.3, 2) }, FactorMeaning::RelativeToRest, 0.0));
  EXPECT_THROW(
    regionWeights(two, areasOf(two), { ball(two, 0, 0.3, 2) }, FactorMeaning::RelativeToRest, 0.1),
    InvalidInput);
}

} // namespace
