// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Conformal/ConformalDisk.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using samples::contains;
using samples::messageOf;

double largestDifference(const Points2& a, const Points2& b)
{
  return (a - b).rowwise().norm().maxCoeff();
}

// Every map has its boundary on the circle, all other vertices within, and a metric that is flat to
// rounding.
void expectConformalDisk(const TriangleMesh& mesh, const ConformalDiskMap& map)
{
  EXPECT_LE(map.MaxCurvatureError, 1e-10);
  EXPECT_LE(map.LayoutError, 1e-6);
  std::vector<char> onBoundary(mesh.vertexCount(), 0);
  for (const int v : requireDisk(mesh))
  {
    onBoundary[v] = 1;
    EXPECT_NEAR(map.Positions.row(v).norm(), 1.0, 1e-15) << v;
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_TRUE(onBoundary[v] || map.Positions.row(v).norm() < 1.0) << v;
  }
}

Eigen::Vector2d areaCentroid(const TriangleMesh& mesh, const Points2& positions)
{
  const Eigen::VectorXd masses = vertexAreas(mesh);
  return (masses.transpose() * positions).transpose() / masses.sum();
}

// A surface without symmetries: the rings of a bump, bent.
TriangleMesh bentSurface(int vertexCount)
{
  TriangleMesh mesh = sunflowerMesh(gaussianBump(0.8, 0.4), vertexCount).Mesh;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double x = mesh.Vertices(v, 0);
    mesh.Vertices(v, 0) = x + 0.3 * x * x;
    mesh.Vertices(v, 2) += 0.4 * x * mesh.Vertices(v, 1) + 0.2 * x * x * x;
  }
  return mesh;
}

TEST(ConformalDisk, FlatDiskMapsToItself)
{
  const RevolutionMesh disk = ringMesh(flatDisk(), 3000);
  const ConformalDiskMap map = conformalDiskMap(disk.Mesh, { 0, disk.FirstBoundaryVertex, {} });
  expectConformalDisk(disk.Mesh, map);
  EXPECT_LT(largestDifference(map.Positions, disk.Mesh.Vertices.leftCols<2>()), 1e-12);
  EXPECT_LT(map.LogFactors.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(map.Untangling.FlippedFaces, 0);

  // Obtuse triangles on the boundary make no difference.
  const RevolutionMesh irregular = sunflowerMesh(flatDisk(), 3000);
  const ConformalDiskMap other =
    conformalDiskMap(irregular.Mesh, { 0, irregular.FirstBoundaryVertex, {} });
  EXPECT_LT(largestDifference(other.Positions, irregular.Mesh.Vertices.leftCols<2>()), 1e-12);
}

struct Case
{
  const char* Name;
  SurfaceOfRevolution Surface;
};

// The case in the test's name.
void PrintTo(const Case& value, std::ostream* stream)
{
  *stream << value.Name;
}

class ConformalRadius : public testing::TestWithParam<Case>
{
};

TEST_P(ConformalRadius, ConvergesToTheAnalyticMap)
{
  const SurfaceOfRevolution& surface = GetParam().Surface;
  std::vector<double> errors;
  for (const int n : { 2500, 10000, 40000 })
  {
    const RevolutionMesh mesh = ringMesh(surface, n);
    const ConformalDiskMap map = conformalDiskMap(mesh.Mesh);
    expectConformalDisk(mesh.Mesh, map);
    EXPECT_EQ(map.Untangling.FlippedFaces, 0);
    EXPECT_LE(map.NewtonIterations, 5) << "of a method that converges quadratically";
    EXPECT_LT(areaCentroid(mesh.Mesh, map.Positions).norm(), 1e-12);
    errors.push_back(radialError(mesh, map.Positions, surface.ConformalRadius));
    EXPECT_LT(largestError(mesh, map.Positions, surface.ConformalRadius), 4.0 * errors.back() + 1e-5);
  }
  for (const double error : errors)
  {
    std::cout << "RMS error of the radius: " << error << "\n";
  }
  EXPECT_LT(errors[1], 3e-4);
  // Twice the resolution has nearly a quarter of the error.
  EXPECT_LT(errors[1], errors[0] / 3.0);
  EXPECT_LT(errors[2], errors[1] / 3.0);
}

TEST_P(ConformalRadius, HoldsOnAnIrregularMesh)
{
  const SurfaceOfRevolution& surface = GetParam().Surface;
  const RevolutionMesh mesh = sunflowerMesh(surface, 10000);
  const ConformalDiskMap map = conformalDiskMap(mesh.Mesh);
  expectConformalDisk(mesh.Mesh, map);
  const double error = radialError(mesh, map.Positions, surface.ConformalRadius);
  EXPECT_LT(error, 3e-4);
  EXPECT_LT(largestError(mesh, map.Positions, surface.ConformalRadius), 3e-3);
}

INSTANTIATE_TEST_SUITE_P(ConformalDisk,
  ConformalRadius,
  testing::Values(Case{ "Hemisphere", sphericalCap(0.5 * EIGEN_PI) },
    Case{ "Paraboloid", paraboloid(1.0) },
    Case{ "GaussianBump", gaussianBump(1.0, 0.3) },
    Case{ "Capsule", capsule(3.0) }),
  [](const auto& info) { return info.param.Name; });

// The factors are those of the analytic map: d rho / ds = rho / r on the meridian.
TEST(ConformalDisk, LogFactorsAreTheAnalyticScale)
{
  const SurfaceOfRevolution hemisphere = sphericalCap(0.5 * EIGEN_PI);
  const RevolutionMesh mesh = ringMesh(hemisphere, 10000);
  const ConformalDiskMap map = conformalDiskMap(mesh.Mesh, { 0, -1, {} });
  for (int v = 1; v < mesh.FirstBoundaryVertex; ++v)
  {
    const double t = mesh.Parameter[v];
    EXPECT_NEAR(map.LogFactors[v], std::log(hemisphere.ConformalRadius(t) / hemisphere.Radius(t)), 5e-3)
      << t;
  }
}

TEST(ConformalDisk, ChosenPointsGoWhereAsked)
{
  const TriangleMesh mesh = bentSurface(2000);
  const std::vector<int> loop = requireDisk(mesh);
  for (const int centre : { 0, 137, 1500 })
  {
    const ConformalDiskMap map = conformalDiskMap(mesh, { centre, loop[17], {} });
    expectConformalDisk(mesh, map);
    EXPECT_EQ(map.Positions.row(centre).norm(), 0.0);
    EXPECT_NEAR(map.Positions(loop[17], 0), 1.0, 1e-15);
    EXPECT_NEAR(map.Positions(loop[17], 1), 0.0, 1e-15);
  }
}

// Two normalisations of one surface differ by a Moebius map of the disk: cross ratios agree.
TEST(ConformalDisk, NormalisationsDifferByAMoebiusMap)
{
  using Complex = std::complex<double>;
  const TriangleMesh mesh = bentSurface(2000);
  const ConformalDiskMap one = conformalDiskMap(mesh);
  const ConformalDiskMap other = conformalDiskMap(mesh, { 400, -1, {} });
  const auto crossRatio = [](const ConformalDiskMap& map, int a, int b, int c, int d)
  {
    const auto z = [&](int v) { return Complex(map.Positions(v, 0), map.Positions(v, 1)); };
    return (z(a) - z(b)) * (z(c) - z(d)) / ((z(b) - z(c)) * (z(d) - z(a)));
  };
  for (int v = 0; v + 1203 < mesh.vertexCount(); v += 7)
  {
    const Complex first = crossRatio(one, v, v + 401, v + 802, v + 1203);
    const Complex second = crossRatio(other, v, v + 401, v + 802, v + 1203);
    EXPECT_LT(std::abs(first - second), 1e-8 * std::abs(first)) << v;
  }
}

TEST(ConformalDisk, DoesNotDependOnNumbering)
{
  const TriangleMesh mesh = bentSurface(3000);
  std::mt19937 random(7);
  std::vector<int> newVertex(mesh.vertexCount());
  std::iota(newVertex.begin(), newVertex.end(), 0);
  std::shuffle(newVertex.begin(), newVertex.end(), random);
  std::vector<int> newFace(mesh.faceCount());
  std::iota(newFace.begin(), newFace.end(), 0);
  std::shuffle(newFace.begin(), newFace.end(), random);
  TriangleMesh renumbered = mesh;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    renumbered.Vertices.row(newVertex[v]) = mesh.Vertices.row(v);
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      renumbered.Faces(newFace[f], k) = newVertex[mesh.Faces(f, (k + f) % 3)];
    }
  }
  const Points2 first = conformalDiskMap(mesh).Positions;
  const Points2 second = conformalDiskMap(renumbered).Positions;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_LT((first.row(v) - second.row(newVertex[v])).norm(), 1e-8) << v;
  }
}

TEST(ConformalDisk, DoesNotDependOnPositionOrUnit)
{
  const TriangleMesh mesh = bentSurface(3000);
  const Points2 expected = conformalDiskMap(mesh).Positions;
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  for (const double scale : { 1.0, 1e9, 1e-9 })
  {
    TriangleMesh moved = mesh;
    moved.Vertices = scale * (mesh.Vertices * rotation.transpose());
    moved.Vertices.rowwise() += scale * Eigen::RowVector3d(30.0, -20.0, 10.0);
    EXPECT_LT(largestDifference(conformalDiskMap(moved).Positions, expected), 1e-8) << scale;
  }
}

// Every third face gets a vertex at 1e-6 of its size from one of its sides: needles and caps.
TriangleMesh withSlivers(const TriangleMesh& mesh, std::vector<Eigen::Index>& parents)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> along(0.001, 0.999);
  TriangleMesh fine = mesh;
  const int added = mesh.faceCount() / 3;
  fine.Vertices.conservativeResize(mesh.vertexCount() + added, 3);
  fine.Faces.conservativeResize(mesh.faceCount() + 2 * added, 3);
  for (int k = 0; k < added; ++k)
  {
    const int f = 3 * k;
    const int a = mesh.Faces(f, 0);
    const int b = mesh.Faces(f, 1);
    const int c = mesh.Faces(f, 2);
    const int m = mesh.vertexCount() + k;
    const double x = along(random);
    const double depth = 1e-6;
    fine.Vertices.row(m) =
      (1.0 - depth) * ((1.0 - x) * mesh.Vertices.row(a) + x * mesh.Vertices.row(b)) +
      depth * mesh.Vertices.row(c);
    fine.Faces.row(f) << a, b, m;
    fine.Faces.row(mesh.faceCount() + 2 * k) << b, c, m;
    fine.Faces.row(mesh.faceCount() + 2 * k + 1) << c, a, m;
    parents.push_back(f);
  }
  return fine;
}

// Vertices added within flat faces do not change the surface: its map stays, to the resolution.
TEST(ConformalDisk, ConvergesOnSlivers)
{
  const RevolutionMesh smooth = ringMesh(gaussianBump(1.0, 0.3), 5000);
  std::vector<Eigen::Index> parents;
  const TriangleMesh slivers = withSlivers(smooth.Mesh, parents);
  const ConformalDiskMap map = conformalDiskMap(slivers, { 0, smooth.FirstBoundaryVertex, {} });
  expectConformalDisk(slivers, map);
  EXPECT_GT(map.Flips, 0);
  const Points2 old = map.Positions.topRows(smooth.Mesh.vertexCount());
  EXPECT_LT(radialError(smooth, old, gaussianBump(1.0, 0.3).ConformalRadius), 2e-4);
  const ConformalDiskMap clean = conformalDiskMap(smooth.Mesh, { 0, smooth.FirstBoundaryVertex, {} });
  EXPECT_LT(largestDifference(old, clean.Positions), 1e-3);
}

TEST(ConformalDisk, OpensFacesWithoutArea)
{
  TriangleMesh mesh = ringMesh(flatDisk(), 500).Mesh;
  // A vertex on the middle of a side.
  const int a = mesh.Faces(100, 0);
  const int b = mesh.Faces(100, 1);
  const int c = mesh.Faces(100, 2);
  const int m = mesh.vertexCount();
  mesh.Vertices.conservativeResize(m + 1, 3);
  mesh.Vertices.row(m) = 0.5 * (mesh.Vertices.row(a) + mesh.Vertices.row(b));
  mesh.Faces.row(100) << a, b, m;
  mesh.Faces.conservativeResize(mesh.faceCount() + 2, 3);
  mesh.Faces.bottomRows<2>() << b, c, m, c, a, m;
  const ConformalDiskMap map = conformalDiskMap(mesh, { 0, -1, {} });
  expectConformalDisk(mesh, map);
  EXPECT_GT(map.AddedLength, 0.0);
  EXPECT_LT(map.AddedLength, 1e-9);
}

// Meshes without an interior vertex. Their three or four boundary points determine the centre of mass
// only: equal masses go to equal angles.
TEST(ConformalDisk, SmallestMeshes)
{
  const TriangleMesh triangle =
    samples::meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.4, 0.5, 0.7 } }, { { 0, 1, 2 } });
  const ConformalDiskMap one = conformalDiskMap(triangle);
  expectConformalDisk(triangle, one);
  EXPECT_LT(areaCentroid(triangle, one.Positions).norm(), 1e-12);
  EXPECT_NEAR((one.Positions.row(0) - one.Positions.row(1)).norm(), std::sqrt(3.0), 1e-12);

  const TriangleMesh pair = samples::meshOf(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 1 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  const ConformalDiskMap two = conformalDiskMap(pair);
  expectConformalDisk(pair, two);
  EXPECT_LT(areaCentroid(pair, two.Positions).norm(), 1e-12);

  // A regular fan goes to the regular hexagon, and so do two rings.
  for (const int n : { 7, 19 })
  {
    const RevolutionMesh fan = ringMesh(flatDisk(), n);
    ASSERT_EQ(fan.Mesh.vertexCount(), n);
    const ConformalDiskMap map = conformalDiskMap(fan.Mesh, { 0, fan.FirstBoundaryVertex, {} });
    expectConformalDisk(fan.Mesh, map);
    EXPECT_LT(largestDifference(map.Positions, fan.Mesh.Vertices.leftCols<2>()), 1e-12);
  }
}

TEST(ConformalDisk, RefusesWhatIsNoDisk)
{
  const TriangleMesh disk = ringMesh(flatDisk(), 100).Mesh;
  const auto topologyMessage = [](const TriangleMesh& mesh)
  { return messageOf<TopologyError>([&] { conformalDiskMap(mesh); }); };
  const auto inputMessage = [](const TriangleMesh& mesh, const ConformalDiskOptions& options)
  { return messageOf<InvalidInput>([&] { conformalDiskMap(mesh, options); }); };

  EXPECT_TRUE(contains(topologyMessage(samples::sphere(2)), "closed"));
  EXPECT_TRUE(contains(topologyMessage(samples::torus(12, 8)), "genus 1"));
  EXPECT_TRUE(contains(topologyMessage(samples::cylinder(12, 4, 1.0)), "2 boundary loops"));
  EXPECT_TRUE(contains(topologyMessage(samples::both(disk, disk)), "2 components"));
  TriangleMesh broken = disk;
  broken.Vertices(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(inputMessage(broken, {}), "vertex 5"));
  broken.Vertices(5, 1) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(contains(inputMessage(broken, {}), "not finite"));
  broken.Vertices.setOnes();
  EXPECT_TRUE(contains(inputMessage(broken, {}), "zero area"));

  const int onBoundary = disk.vertexCount() - 1;
  EXPECT_TRUE(contains(inputMessage(disk, { onBoundary, -1, {} }), "not an interior vertex"));
  EXPECT_TRUE(contains(inputMessage(disk, { disk.vertexCount(), -1, {} }), "not an interior vertex"));
  EXPECT_TRUE(contains(inputMessage(disk, { -1, 0, {} }), "not on the boundary"));
}

TEST(ConformalDisk, ProgressGrowsAndCancels)
{
  const TriangleMesh mesh = ringMesh(sphericalCap(1.5), 1000).Mesh;
  std::vector<double> fractions; // without fractions repeated while a library is at work
  conformalDiskMap(mesh,
    {},
    [&fractions](double fraction, const char*)
    {
      if (fractions.empty() || fraction != fractions.back())
      {
        fractions.push_back(fraction);
      }
      return true;
    });
  ASSERT_GT(fractions.size(), 3u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GE(fractions.front(), 0.0);
  EXPECT_EQ(fractions.back(), 1.0);
  for (const double stop : fractions)
  {
    bool isOver = false;
    EXPECT_THROW(conformalDiskMap(mesh,
                   {},
                   [&](double fraction, const char*)
                   {
                     EXPECT_FALSE(isOver) << "went on after the stop";
                     isOver = fraction >= stop;
                     return !isOver;
                   }),
      Cancelled);
  }
}

// A strip of needles, each three hundred times as long as wide: no vertex at infinity gives it a map,
// and each attempt would take up to sixty Newton steps.
TEST(ConformalDisk, TriesNoThirdVertexAfterFlowsThatFailLate)
{
  constexpr int Quads = 100;
  TriangleMesh strip{ Points3(2 * Quads + 2, 3), FaceMatrix(2 * Quads, 3) };
  for (int i = 0; i <= Quads; ++i)
  {
    strip.Vertices.row(2 * i) << 0.003 * i, 0.0, 0.0;
    strip.Vertices.row(2 * i + 1) << 0.003 * i, 1.0, 0.0;
  }
  for (int i = 0; i < Quads; ++i)
  {
    strip.Faces.row(2 * i) << 2 * i, 2 * i + 2, 2 * i + 3;
    strip.Faces.row(2 * i + 1) << 2 * i, 2 * i + 3, 2 * i + 1;
  }
  double reached = 0.0; // the second of four attempts has the progress from 0.3 to 0.5
  EXPECT_THROW(conformalDiskMap(strip,
                 {},
                 [&reached](double fraction, const char*)
                 {
                   reached = fraction;
                   return true;
                 }),
    ConvergenceError);
  EXPECT_GT(reached, 0.3);
  EXPECT_LT(reached, 0.5);
}

// Seen from a vertex at its end, a long strip is a speck: of the strip of 15:1, the half-plane then has
// too few digits, and 21 faces stayed flipped.
TEST(ConformalDisk, LongStripsAreCentred)
{
  for (const int aspect : { 5, 10, 15 })
  {
    const TriangleMesh strip = samples::rectangleGrid(3 * aspect, 7, std::sqrt(samples::Pi * aspect));
    const ConformalDiskMap map = conformalDiskMap(strip);
    const Eigen::VectorXd masses = vertexAreas(strip);
    // Points that a disk shrinks too much are moved apart, which moves the centroid.
    EXPECT_LT((masses.transpose() * map.Positions).norm() / masses.sum(), 0.15) << aspect;
    EXPECT_LE(map.Positions.rowwise().norm().maxCoeff(), 1.0 + 1e-15) << aspect;
    EXPECT_LT(map.Positions.rowwise().norm().minCoeff(), 0.9) << aspect;
    EXPECT_LE(map.Untangling.FlippedFaces, 5) << aspect;
  }
}

TEST(ConformalDisk, SameBitsWhateverTheThreads)
{
  const TriangleMesh mesh = bentSurface(10000);
  const Points2 first = conformalDiskMap(mesh).Positions;
  for (const std::size_t threads : { 1, 2, 4 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_TRUE((conformalDiskMap(mesh).Positions.array() == first.array()).all()) << threads;
  }
}

} // namespace
