// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/AreaPreservingDisk.h"
#include "Conformal/ConformalDisk.h"
#include "Disk/SurfaceToDisk.h"
#include "FlatMap/DistortionMeasures.h"
#include "FlatMap/DistortionSummary.h"
#include "Mesh/MeshTopology.h"
#include "Support/RandomSurfaces.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

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
using samples::rectangleGrid;

Points2 conformal(const TriangleMesh& mesh)
{
  return conformalDiskMap(mesh).Positions;
}

// The properties of every map.
void expectAreaPreserving(const TriangleMesh& mesh, const AreaPreservingResult& result, double tolerance)
{
  const AreaPreservingMap& map = result.Map;
  EXPECT_NEAR(map.CellAreas.sum(), Pi, 1e-12);
  EXPECT_NEAR(map.TargetAreas.sum(), Pi, 1e-12);
  EXPECT_LE(map.MaxCellError, tolerance);
  EXPECT_LE(((map.CellAreas - map.TargetAreas).array() / map.TargetAreas.array()).abs().maxCoeff(),
    map.MaxCellError + 1e-14);
  std::vector<char> onBoundary(mesh.vertexCount(), 0);
  const std::vector<int> loop = requireDisk(mesh);
  double turn = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    onBoundary[loop[k]] = 1;
    EXPECT_NEAR(map.Positions.row(loop[k]).norm(), 1.0, 1e-15);
    const Eigen::RowVector2d a = map.Positions.row(loop[k]);
    const Eigen::RowVector2d b = map.Positions.row(loop[(k + 1) % loop.size()]);
    const double step = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    EXPECT_GT(step, 0.0) << "boundary vertices out of order at " << loop[k];
    turn += step;
  }
  EXPECT_NEAR(turn, 2.0 * Pi, 1e-12) << "the boundary runs around once";
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_TRUE(onBoundary[v] || map.Positions.row(v).norm() < 1.0) << v;
  }
}

// The cells alone: what the transport is measured by.
AreaPreservingOptions transportAlone(double tolerance = 1e-6)
{
  AreaPreservingOptions options;
  options.RefineFaces = false;
  options.Transport.Tolerance = tolerance;
  return options;
}

TEST(AreaPreservingDisk, FlatDiskMapsNearlyToItself)
{
  // Cells are not triangles: a vertex moves by a part of its cell. It shrinks with the mesh.
  double previous = 1.0;
  for (const int n : { 1000, 4000, 16000 })
  {
    const RevolutionMesh disk = ringMesh(flatDisk(), n);
    const Points2 flat = disk.Mesh.Vertices.leftCols<2>();
    const AreaPreservingResult result = areaPreservingDiskMap(disk.Mesh, flat, {}, transportAlone());
    expectAreaPreserving(disk.Mesh, result, 1e-6);
    EXPECT_EQ(result.Map.FlippedFaces, 0);
    const double error = radialError(disk, result.Map.Positions, flatDisk().ConformalRadius);
    std::cout << "RMS error of the radius: " << error << "\n";
    EXPECT_LT(error, previous / 2.0);
    previous = error;
  }
  EXPECT_LT(previous, 1e-4);
}

struct Case
{
  const char* Name;
  SurfaceOfRevolution Surface;
};

// The name of a case in the names of its tests.
void PrintTo(const Case& value, std::ostream* stream)
{
  *stream << value.Name;
}

class BrenierRadius : public testing::TestWithParam<Case>
{
};

TEST_P(BrenierRadius, ConvergesToTheAnalyticMap)
{
  const SurfaceOfRevolution& surface = GetParam().Surface;
  const auto radius = [&surface](double t) { return surface.brenierRadius(t); };
  std::vector<double> errors;
  for (const int n : { 2500, 10000, 40000 })
  {
    const RevolutionMesh mesh = ringMesh(surface, n);
    const AreaPreservingResult result =
      areaPreservingDiskMap(mesh.Mesh, conformal(mesh.Mesh), {}, transportAlone());
    expectAreaPreserving(mesh.Mesh, result, 1e-6);
    EXPECT_EQ(result.Map.FlippedFaces, 0);
    errors.push_back(radialError(mesh, result.Map.Positions, radius));
    std::cout << "RMS error of the radius: " << errors.back() << " in " << result.Map.NewtonIterations
              << " Newton steps\n";
  }
  EXPECT_LT(errors[1], 3e-4);
  EXPECT_LT(errors[1], errors[0] / 2.0);
  EXPECT_LT(errors[2], errors[1] / 2.0);
}

TEST_P(BrenierRadius, HoldsOnAnIrregularMesh)
{
  const SurfaceOfRevolution& surface = GetParam().Surface;
  const RevolutionMesh mesh = sunflowerMesh(surface, 10000);
  const AreaPreservingResult result =
    areaPreservingDiskMap(mesh.Mesh, conformal(mesh.Mesh), {}, transportAlone());
  expectAreaPreserving(mesh.Mesh, result, 1e-6);
  const double error =
    radialError(mesh, result.Map.Positions, [&](double t) { return surface.brenierRadius(t); });
  std::cout << "RMS error of the radius: " << error << "\n";
  EXPECT_LT(error, 3e-4);
}

INSTANTIATE_TEST_SUITE_P(AreaPreservingDisk,
  BrenierRadius,
  testing::Values(Case{ "Hemisphere", sphericalCap(0.5 * EIGEN_PI) },
    Case{ "Paraboloid", paraboloid(1.0) },
    Case{ "GaussianBump", gaussianBump(1.0, 0.3) },
    Case{ "Capsule", capsule(3.0) }),
  [](const auto& info) { return info.param.Name; });

TEST(TargetAreas, AreThirdsOfTheFacesTimesTheWeights)
{
  const TriangleMesh pair = samples::meshOf(
    { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 4, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  // Face areas 2 and 4: thirds 2, 2/3, 2, 4/3 of 6.
  const Eigen::Vector4d thirds(2.0, 2.0 / 3.0, 2.0, 4.0 / 3.0);
  EXPECT_LT((targetAreas(pair, {}) - thirds * (Pi / 6.0)).norm(), 1e-15);
  const Eigen::Vector4d weights(1.0, 3.0, 0.5, 10.0);
  const Eigen::Vector4d weighted = thirds.cwiseProduct(weights);
  EXPECT_LT((targetAreas(pair, weights) - weighted * (Pi / weighted.sum())).norm(), 1e-15);
}

// The sites of the boundary's vertices are theirs alone, so that none are left to be taken together.
TEST(AreaPreservingDisk, EveryVertexMayLieOnTheBoundary)
{
  constexpr int n = 2200; // more than the least number of vertices that share sites
  TriangleMesh polygon;
  polygon.Vertices = Points3::Zero(n, 3);
  for (int k = 0; k < n; ++k)
  {
    const double angle = 2.0 * Pi * k / n;
    polygon.Vertices.row(k).head<2>() << std::cos(angle), std::sin(angle);
  }
  polygon.Faces.resize(n - 2, 3);
  int low = 0;
  int high = n - 1;
  for (int f = 0; f < n - 2; ++f) // a zigzag across the polygon
  {
    polygon.Faces.row(f) << low, f % 2 == 0 ? low + 1 : high - 1, high;
    f % 2 == 0 ? ++low : --high;
  }
  AreaPreservingOptions options;
  options.VerticesPerSite = 16;
  const AreaPreservingResult result =
    areaPreservingDiskMap(polygon, polygon.Vertices.leftCols<2>(), {}, options);
  EXPECT_TRUE(result.Map.Bijective);
}

// Splits every @p step-th edge of the boundary near its first end, as cuts along paths do.
TriangleMesh withTinyEdges(TriangleMesh mesh, int step)
{
  constexpr double share = 0.03; // of the edge
  const std::vector<int> loop = requireDisk(mesh);
  std::vector<Eigen::RowVector3i> added;
  for (std::size_t k = 0; k < loop.size(); k += step)
  {
    const int a = loop[k];
    const int b = loop[(k + 1) % loop.size()];
    const int middle = mesh.vertexCount();
    mesh.Vertices.conservativeResize(middle + 1, 3);
    mesh.Vertices.row(middle) = (1.0 - share) * mesh.Vertices.row(a) + share * mesh.Vertices.row(b);
    for (int corner = 0; corner < 3 * mesh.faceCount(); ++corner)
    {
      auto face = mesh.Faces.row(corner / 3);
      const int next = (corner + 1) % 3;
      if (face[corner % 3] == a && face[next] == b)
      {
        added.push_back({ middle, b, face[(corner + 2) % 3] });
        face[next] = middle;
      }
    }
  }
  const int faces = mesh.faceCount();
  mesh.Faces.conservativeResize(faces + static_cast<Eigen::Index>(added.size()), 3);
  for (std::size_t f = 0; f < added.size(); ++f)
  {
    mesh.Faces.row(faces + static_cast<Eigen::Index>(f)) = added[f];
  }
  return mesh;
}

// Their faces are slivers, whose areas they would keep a hundred times as long as well.
TEST(AreaPreservingDisk, TinyEdgesOfTheBoundaryAreStretchedLikeOthers)
{
  const TriangleMesh mesh =
    withTinyEdges(analytic::sunflowerMesh(analytic::sphericalCap(1.2), 3000).Mesh, 7);
  const std::vector<int> loop = requireDisk(mesh);
  const AreaPreservingMap map = areaPreservingDiskMap(mesh, conformal(mesh)).Map;
  EXPECT_TRUE(map.Bijective);
  const double scale = std::sqrt(faceAreas(mesh.Vertices, mesh.Faces).sum() / Pi);
  double greatest = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const int a = loop[k];
    const int b = loop[(k + 1) % loop.size()];
    greatest = std::max(greatest,
      scale * (map.Positions.row(a) - map.Positions.row(b)).norm() /
        (mesh.Vertices.row(a) - mesh.Vertices.row(b)).norm());
  }
  EXPECT_LT(greatest, 4.0); // 2.4, and 85 without a limit
}

// Twice the weight, twice the area relative to the rest: exactly, to the tolerance of the cells.
TEST(AreaPreservingDisk, DoublingAWeightDoublesTheArea)
{
  const RevolutionMesh mesh = sunflowerMesh(gaussianBump(1.0, 0.3), 5000);
  const Points2 flat = conformal(mesh.Mesh);
  const int n = mesh.Mesh.vertexCount();
  Eigen::VectorXd region = Eigen::VectorXd::Zero(n);
  for (int v = 0; v < n; ++v)
  {
    const double dx = mesh.Mesh.Vertices(v, 0) - 0.3;
    const double dy = mesh.Mesh.Vertices(v, 1) + 0.2;
    region[v] = dx * dx + dy * dy < 0.09 ? 1.0 : 0.0;
  }
  ASSERT_GT(region.sum(), 200.0);
  const auto relativeArea = [&](const Eigen::VectorXd& weights)
  {
    const AreaPreservingResult result =
      areaPreservingDiskMap(mesh.Mesh, flat, weights, transportAlone(1e-10));
    expectAreaPreserving(mesh.Mesh, result, 1e-10);
    const double inside = result.Map.CellAreas.dot(region);
    return inside / (Pi - inside);
  };
  const double before = relativeArea({});
  for (const double factor : { 2.0, 0.5, 4.0 })
  {
    const Eigen::VectorXd weights = (1.0 + (factor - 1.0) * region.array()).matrix();
    EXPECT_NEAR(relativeArea(weights) / before, factor, 1e-9 * factor);
  }
}

// A start from the weights of a neighbouring problem: fewer steps to the same map.
TEST(AreaPreservingDisk, WarmStart)
{
  const RevolutionMesh mesh = sunflowerMesh(sphericalCap(2.0), 5000);
  const Points2 flat = conformal(mesh.Mesh);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(mesh.Mesh.vertexCount());
  const AreaPreservingMap before = areaPreservingDiskMap(mesh.Mesh, flat, weights, transportAlone()).Map;
  for (int v = 0; v < mesh.Mesh.vertexCount(); ++v)
  {
    weights[v] = mesh.Mesh.Vertices(v, 0) > 0.5 ? 1.1 : 1.0;
  }
  const AreaPreservingMap cold = areaPreservingDiskMap(mesh.Mesh, flat, weights, transportAlone()).Map;
  AreaPreservingOptions options = transportAlone();
  options.Start.PowerWeights = before.PowerWeights;
  const AreaPreservingMap warm = areaPreservingDiskMap(mesh.Mesh, flat, weights, options).Map;
  std::cout << "Newton steps: " << cold.NewtonIterations << " cold, " << warm.NewtonIterations
            << " warm\n";
  EXPECT_LT(warm.NewtonIterations, cold.NewtonIterations);
  EXPECT_LE(warm.MaxCellError, 1e-6);
  EXPECT_LT((warm.Positions - cold.Positions).rowwise().norm().maxCoeff(), 1e-6);

  options.Start.PowerWeights.setConstant(std::nan(""));
  const AreaPreservingMap unusable = areaPreservingDiskMap(mesh.Mesh, flat, weights, options).Map;
  EXPECT_EQ(unusable.NewtonIterations, cold.NewtonIterations) << "a start of no use is not taken";
}

// Weights count only relative to each other.
TEST(AreaPreservingDisk, ACommonFactorOfTheWeightsChangesNothing)
{
  const RevolutionMesh mesh = ringMesh(sphericalCap(1.0), 1000);
  const Points2 flat = conformal(mesh.Mesh);
  const Points2 expected = areaPreservingDiskMap(mesh.Mesh, flat).Map.Positions;
  const Eigen::VectorXd weights = Eigen::VectorXd::Constant(mesh.Mesh.vertexCount(), 1024.0);
  const Points2 found = areaPreservingDiskMap(mesh.Mesh, flat, weights).Map.Positions;
  EXPECT_LT((found - expected).rowwise().norm().maxCoeff(), 1e-12);
}

TEST(AreaPreservingDisk, WeightsOverSixDecades)
{
  const RevolutionMesh mesh = ringMesh(sphericalCap(0.5 * EIGEN_PI), 3000);
  Eigen::VectorXd weights(mesh.Mesh.vertexCount());
  for (Eigen::Index v = 0; v < weights.size(); ++v)
  {
    weights[v] = std::pow(10.0, 3.0 * std::sin(3.0 * mesh.Angle[v]) * std::sin(2.0 * mesh.Parameter[v]));
  }
  ASSERT_GT(weights.maxCoeff() / weights.minCoeff(), 9e5);
  const AreaPreservingResult result = areaPreservingDiskMap(mesh.Mesh, conformal(mesh.Mesh), weights);
  expectAreaPreserving(mesh.Mesh, result, 1e-6);
  EXPECT_TRUE(result.Map.Bijective);
}

// The flipped faces of the first transported map of this surface, remeshed noise with a hole, cannot be
// untangled. With one transport, 4 % of the faces are within 2 %.
TEST(AreaPreservingDisk, TransportsAgainFromAMapOnTheWay)
{
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Hole;
  options.Remesh = true;
  const TriangleMesh mesh = surfaceToDisk(samples::randomSurface(407).Mesh, options).Surface.Mesh;
  const AreaPreservingMap map = areaPreservingDiskMap(mesh, conformal(mesh)).Map;
  EXPECT_TRUE(map.Bijective);
  EXPECT_EQ(map.StartShare, 1.0);
  EXPECT_GE(summariseDistortion(measureDistortion(mesh, map.Positions)).FacesWithin2Percent, 60.0);
}

// A few faces of the transported maps of these surfaces are inside out. Untangled by moving a large part
// of the map, 5 % of the faces were within 2 %.
TEST(AreaPreservingDisk, UntanglesPartsThatAreInsideOutWithoutLosingAreas)
{
  for (const int seed : { 18, 196 })
  {
    const TriangleMesh mesh = surfaceToDisk(samples::randomSurface(seed).Mesh).Surface.Mesh;
    const AreaPreservingMap map = areaPreservingDiskMap(mesh, conformal(mesh)).Map;
    EXPECT_TRUE(map.Bijective) << seed;
    EXPECT_GT(map.RepairedFaces, 0) << seed;
    EXPECT_GE(summariseDistortion(measureDistortion(mesh, map.Positions)).FacesWithin2Percent, 95.0)
      << seed;
  }
}

TEST(AreaPreservingDisk, CoincidentVerticesShareACell)
{
  const RevolutionMesh mesh = ringMesh(sphericalCap(1.2), 2000);
  Points2 flat = conformal(mesh.Mesh);
  flat.row(101) = flat.row(100);
  flat.row(102) = flat.row(100);
  flat.row(7) = flat.row(900);
  const AreaPreservingResult result = areaPreservingDiskMap(mesh.Mesh, flat, {}, transportAlone());
  expectAreaPreserving(mesh.Mesh, result, 1e-6);
  EXPECT_EQ(result.Map.CoincidentVertices, 3);
  EXPECT_EQ(result.Diagram.siteCount(), mesh.Mesh.vertexCount() - 3);
  EXPECT_EQ(result.SiteOfVertex[100], result.SiteOfVertex[101]);
  EXPECT_EQ(result.SiteOfVertex[100], result.SiteOfVertex[102]);
  EXPECT_EQ(result.SiteOfVertex[7], result.SiteOfVertex[900]);
  EXPECT_EQ(result.Map.Positions.row(100), result.Map.Positions.row(102));
  const int site = result.SiteOfVertex[100];
  EXPECT_NEAR(result.Map.CellAreas.segment(100, 3).sum(), result.Diagram.areas()[site], 1e-16);
}

TEST(AreaPreservingDisk, RefusesWeightsThatAreNone)
{
  const RevolutionMesh mesh = ringMesh(sphericalCap(1.0), 200);
  const Points2 flat = conformal(mesh.Mesh);
  for (const double bad : { 0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(mesh.Mesh.vertexCount());
    weights[42] = bad;
    const std::string message =
      messageOf<InvalidInput>([&] { areaPreservingDiskMap(mesh.Mesh, flat, weights); });
    EXPECT_TRUE(contains(message, "the area weight of vertex 42 is ")) << message;
    EXPECT_TRUE(contains(message, "must be positive")) << message;
  }
}

TEST(AreaPreservingDisk, RefusesWhatIsNoDiskMap)
{
  const RevolutionMesh mesh = ringMesh(sphericalCap(1.0), 200);
  const Points2 flat = conformal(mesh.Mesh);
  const auto message = [&](const Points2& positions)
  { return messageOf<InvalidInput>([&] { areaPreservingDiskMap(mesh.Mesh, positions); }); };
  Points2 wrong = flat;
  wrong.row(mesh.FirstBoundaryVertex + 1) *= 0.99;
  EXPECT_TRUE(contains(message(wrong),
    "boundary vertex " + std::to_string(mesh.FirstBoundaryVertex + 1) + " does not lie"));
  wrong = flat;
  wrong.row(3) << 0.9, 0.9;
  EXPECT_TRUE(contains(message(wrong), "vertex 3 lies outside of the disk"));
  wrong(3, 0) = std::nan("");
  EXPECT_TRUE(contains(message(wrong), "run Conformal Disk first"));

  // A vertex of faces without area carries nothing.
  TriangleMesh flattened = mesh.Mesh;
  for (const int v : { 1, 2, 3, 4, 5, 6 })
  {
    flattened.Vertices.row(v) = flattened.Vertices.row(0);
  }
  EXPECT_TRUE(contains(
    messageOf<InvalidInput>([&] { areaPreservingDiskMap(flattened, flat); }), "vertex 0 has no area"));
}

TEST(AreaPreservingDisk, CancelsAnywhere)
{
  const RevolutionMesh mesh = ringMesh(gaussianBump(1.0, 0.3), 500);
  const Points2 flat = conformal(mesh.Mesh);
  std::vector<double> fractions;
  areaPreservingDiskMap(mesh.Mesh,
    flat,
    {},
    {},
    [&](double fraction, const char*)
    {
      if (fractions.empty() || fraction != fractions.back()) // not repeated while a library is at work
      {
        fractions.push_back(fraction);
      }
      return true;
    });
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
  for (const double stop : fractions)
  {
    EXPECT_THROW(
      areaPreservingDiskMap(
        mesh.Mesh, flat, {}, {}, [stop](double fraction, const char*) { return fraction < stop; }),
      Cancelled);
  }
}

TEST(AreaPreservingDisk, SameBitsWhateverTheThreads)
{
  const RevolutionMesh mesh = sunflowerMesh(sphericalCap(2.0), 10000);
  const Points2 flat = conformal(mesh.Mesh);
  const Points2 expected = areaPreservingDiskMap(mesh.Mesh, flat).Map.Positions;
  for (const std::size_t threads : { 1, 2, 4 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Points2 found = areaPreservingDiskMap(mesh.Mesh, flat).Map.Positions;
    EXPECT_TRUE((found.array() == expected.array()).all()) << threads;
  }
}

// A density that grows along the rectangle spreads along it: x goes to the share of mass before x.
TEST(AreaPreservingRectangle, DensityAlongTheRectangle)
{
  constexpr int columns = 81;
  constexpr int rows = 31;
  constexpr double width = 3.0;
  const TriangleMesh mesh = rectangleGrid(columns, rows, width);
  const Points2 conformal = mesh.Vertices.leftCols<2>();
  Eigen::VectorXd weights(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    weights[v] = 1.0 + 0.6 * conformal(v, 0) / (0.5 * width);
  }
  const AreaPreservingResult result =
    areaPreservingRectangleMap(mesh, conformal, width, weights, transportAlone());
  EXPECT_LE(result.Map.MaxCellError, 1e-6);
  EXPECT_EQ(result.Map.FlippedFaces, 0);
  EXPECT_NEAR(result.Map.CellAreas.sum(), Pi, 1e-11);
  double largest = 0.0;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const int v = j * columns + i;
      const double s = conformal(v, 0) / (0.5 * width);
      const double share = 0.5 * (s + 1.0) + 0.15 * (s * s - 1.0);
      const Eigen::RowVector2d expected(width * (share - 0.5), conformal(v, 1));
      largest = std::max(largest, (result.Map.Positions.row(v) - expected).norm());
      if (i == 0 || i == columns - 1)
      {
        ASSERT_NEAR(result.Map.Positions(v, 0), conformal(v, 0), 1e-15) << "stays on its side";
      }
      if (j == 0 || j == rows - 1)
      {
        ASSERT_NEAR(result.Map.Positions(v, 1), conformal(v, 1), 1e-15) << "stays on its side";
      }
    }
  }
  std::cout << "greatest distance from the exact map: " << largest << '\n';
  EXPECT_LT(largest, 0.5 * width / columns);
  for (const int corner : { 0, columns - 1, columns * (rows - 1), columns * rows - 1 })
  {
    EXPECT_LT((result.Map.Positions.row(corner) - conformal.row(corner)).norm(), 1e-15);
  }
}

TEST(AreaPreservingRectangle, RefusesWhatIsNoMapToARectangle)
{
  const TriangleMesh mesh = rectangleGrid(11, 6, 2.0);
  const Points2 conformal = mesh.Vertices.leftCols<2>();
  const auto message = [&](const Points2& positions, double width) -> std::string
  {
    try
    {
      areaPreservingRectangleMap(mesh, positions, width);
    }
    catch (const InvalidInput& error)
    {
      return error.what();
    }
    return "no error";
  };
  EXPECT_TRUE(contains(message(conformal, 2.1), "no boundary vertex lies in corner 0"));
  EXPECT_TRUE(contains(message(conformal, 0.0), "must be positive"));
  Points2 wrong = conformal;
  wrong(5, 1) += 0.01;
  EXPECT_TRUE(contains(message(wrong, 2.0), "vertex 5 does not lie on the sides of the rectangle"));
  wrong = conformal;
  wrong(15, 1) = 5.0;
  EXPECT_TRUE(contains(message(wrong, 2.0), "vertex 15 lies outside of the rectangle"));
  wrong = conformal;
  wrong.col(0) *= -1.0;
  EXPECT_TRUE(contains(message(wrong, 2.0), "mirrored"));
}

} // namespace
