// SPDX-License-Identifier: GPL-3.0-or-later
/// Boundary First and Mean Value, and the rules that all methods for the conformal disk share.
#include "AnalyticSurfaces.h"
#include "Conformal/ConformalDisk.h"
#include "Disk/SurfaceToDisk.h"
#include "FlatMap/DistortionSummary.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/LongestEdgeBisection.h"
#include "Support/AbandonedCall.h"
#include "Support/RandomSurfaces.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iostream>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using samples::contains;
using samples::messageOf;
using Complex = std::complex<double>;

ConformalDiskOptions optionsOf(ConformalMethod method, int centre = -1, int boundary = -1)
{
  ConformalDiskOptions options;
  options.CenterVertex = centre;
  options.BoundaryVertex = boundary;
  options.Method = method;
  return options;
}

double largestDifference(const Points2& a, const Points2& b)
{
  return (a - b).rowwise().norm().maxCoeff();
}

Eigen::Vector2d areaCentroid(const TriangleMesh& mesh, const Points2& positions)
{
  const Eigen::VectorXd masses = vertexAreas(mesh);
  return (masses.transpose() * positions).transpose() / masses.sum();
}

// A part of the sphere without symmetry whose conformal map to the disk is known: the disk's image under
// z + 0.3 z^2, carried to the sphere by the inverse of the stereographic projection.
struct SpherePart
{
  TriangleMesh Mesh;
  Points2 Disk;             // where the conformal map with 0 -> vertex 0 takes the vertices
  Eigen::VectorXd LogScale; // its logarithm of flat over surface length
  int Right;                // the boundary vertex at angle 0
};

SpherePart spherePart(int vertexCount)
{
  const RevolutionMesh disk = sunflowerMesh(flatDisk(), vertexCount);
  SpherePart part{ disk.Mesh, disk.Mesh.Vertices.leftCols<2>(), {}, disk.FirstBoundaryVertex };
  part.LogScale.resize(disk.Mesh.vertexCount());
  for (int v = 0; v < disk.Mesh.vertexCount(); ++v)
  {
    const Complex z(part.Disk(v, 0), part.Disk(v, 1));
    const Complex w = z + 0.3 * z * z;
    const double denominator = 1.0 + std::norm(w);
    part.Mesh.Vertices.row(v) << 2.0 * w.real() / denominator, 2.0 * w.imag() / denominator,
      (1.0 - std::norm(w)) / denominator;
    part.LogScale[v] = -std::log(2.0 * std::abs(1.0 + 0.6 * z) / denominator);
  }
  return part;
}

class ConformalMethods : public testing::TestWithParam<ConformalMethod>
{
};

INSTANTIATE_TEST_SUITE_P(ConformalDisk,
  ConformalMethods,
  testing::Values(ConformalMethod::RicciFlow,
    ConformalMethod::BoundaryFirst,
    ConformalMethod::MeanValue),
  [](const auto& info)
  {
    return info.param == ConformalMethod::RicciFlow       ? "RicciFlow"
           : info.param == ConformalMethod::BoundaryFirst ? "BoundaryFirst"
                                                          : "MeanValue";
  });

void expectInDisk(const TriangleMesh& mesh, const ConformalDiskMap& map)
{
  std::vector<char> onBoundary(mesh.vertexCount(), 0);
  double angle = -1.0;
  int turns = 0;
  for (const int v : requireDisk(mesh))
  {
    onBoundary[v] = 1;
    EXPECT_NEAR(map.Positions.row(v).norm(), 1.0, 1e-15) << v;
    const double next = std::atan2(map.Positions(v, 1), map.Positions(v, 0));
    turns += next <= angle;
    angle = next;
  }
  EXPECT_LE(turns, 2) << "the boundary vertices are in order, from any of them on";
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_TRUE(onBoundary[v] || map.Positions.row(v).norm() < 1.0) << v;
  }
}

// Every method is exact on functions that are linear on the surface.
TEST_P(ConformalMethods, FlatDiskMapsToItself)
{
  for (const RevolutionMesh& disk : { ringMesh(flatDisk(), 3000), sunflowerMesh(flatDisk(), 3000) })
  {
    const ConformalDiskMap map =
      conformalDiskMap(disk.Mesh, optionsOf(GetParam(), 0, disk.FirstBoundaryVertex));
    expectInDisk(disk.Mesh, map);
    EXPECT_LT(largestDifference(map.Positions, disk.Mesh.Vertices.leftCols<2>()), 1e-11);
    EXPECT_LT(map.LogFactors.cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_EQ(map.Untangling.FlippedFaces, 0);
  }
}

TEST_P(ConformalMethods, ShareOneNormalisation)
{
  const SpherePart part = spherePart(3000);
  const std::vector<int> loop = requireDisk(part.Mesh);
  for (const int centre : { -1, 0, 137, 1500 })
  {
    const ConformalDiskMap map = conformalDiskMap(part.Mesh, optionsOf(GetParam(), centre, loop[17]));
    expectInDisk(part.Mesh, map);
    EXPECT_EQ(map.Untangling.FlippedFaces, 0);
    EXPECT_NEAR(map.Positions(loop[17], 0), 1.0, 1e-15);
    EXPECT_NEAR(map.Positions(loop[17], 1), 0.0, 1e-15);
    if (centre >= 0)
    {
      EXPECT_EQ(map.Positions.row(centre).norm(), 0.0);
    }
    else
    {
      EXPECT_LT(areaCentroid(part.Mesh, map.Positions).norm(), 1e-12);
    }
  }
  // Without a boundary vertex the rotation is the one that the method's own shape of the disk implies:
  // the mass that is far from the surface's centroid lies to the right.
  const ConformalDiskMap map = conformalDiskMap(part.Mesh, optionsOf(GetParam()));
  const Eigen::VectorXd masses = vertexAreas(part.Mesh);
  const Eigen::RowVector3d centroid = masses.transpose() * part.Mesh.Vertices / masses.sum();
  const Eigen::VectorXd far =
    masses.cwiseProduct((part.Mesh.Vertices.rowwise() - centroid).rowwise().norm());
  const Eigen::RowVector2d direction = far.transpose() * map.Positions;
  EXPECT_GT(direction.x(), 0.0);
  EXPECT_LT(std::abs(direction.y()), 1e-12 * far.sum());
}

// If the centre lies next to a boundary vertex, this vertex outweighs all others.
TEST_P(ConformalMethods, CentreNextToTheBoundary)
{
  TriangleMesh fan = ringMesh(flatDisk(), 7).Mesh;
  for (const double distance : { 0.1, 1e-5 })
  {
    fan.Vertices.row(0) << 1.0 - distance, 0.0, 0.0;
    const ConformalDiskMap map = conformalDiskMap(fan, optionsOf(GetParam(), 0));
    expectInDisk(fan, map);
    EXPECT_EQ(map.Positions.row(0).norm(), 0.0);
    EXPECT_LT(areaCentroid(fan, conformalDiskMap(fan, optionsOf(GetParam())).Positions).norm(), 1e-12);
  }
}

TEST_P(ConformalMethods, SmallestMeshes)
{
  const TriangleMesh triangle =
    samples::meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.4, 0.5, 0.7 } }, { { 0, 1, 2 } });
  const TriangleMesh pair = samples::meshOf(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 1 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  const TriangleMesh opened = samples::withoutFaces(samples::tetrahedron(), { 3 });
  for (const TriangleMesh& mesh : { triangle, pair, opened, ringMesh(flatDisk(), 19).Mesh })
  {
    const ConformalDiskMap map = conformalDiskMap(mesh, optionsOf(GetParam()));
    expectInDisk(mesh, map);
    EXPECT_LT(areaCentroid(mesh, map.Positions).norm(), 1e-12);
    EXPECT_EQ(map.Untangling.FlippedFaces, 0);
  }
  const ConformalDiskMap map = conformalDiskMap(triangle, optionsOf(GetParam()));
  EXPECT_NEAR((map.Positions.row(0) - map.Positions.row(1)).norm(), std::sqrt(3.0), 1e-12);
}

TEST_P(ConformalMethods, DoNotDependOnPositionOrUnitOrNumbering)
{
  const TriangleMesh mesh = spherePart(3000).Mesh;
  const Points2 expected = conformalDiskMap(mesh, optionsOf(GetParam())).Positions;
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  std::mt19937 random(7);
  std::vector<int> newVertex(mesh.vertexCount());
  std::iota(newVertex.begin(), newVertex.end(), 0);
  std::shuffle(newVertex.begin(), newVertex.end(), random);
  for (const double scale : { 1.0, 1e9, 1e-9 })
  {
    TriangleMesh moved = mesh;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      moved.Vertices.row(newVertex[v]) =
        scale * (mesh.Vertices.row(v) * rotation.transpose() + Eigen::RowVector3d(30.0, -20.0, 10.0));
    }
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        moved.Faces(mesh.faceCount() - 1 - f, k) = newVertex[mesh.Faces(f, (k + f) % 3)];
      }
    }
    const Points2 positions = conformalDiskMap(moved, optionsOf(GetParam())).Positions;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      ASSERT_LT((positions.row(newVertex[v]) - expected.row(v)).norm(), 1e-8) << scale << ' ' << v;
    }
  }
}

TEST_P(ConformalMethods, SameBitsWhateverTheThreads)
{
  const TriangleMesh mesh = spherePart(10000).Mesh;
  const ConformalDiskMap first = conformalDiskMap(mesh, optionsOf(GetParam()));
  for (const std::size_t threads : { 1, 2, 4 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const ConformalDiskMap map = conformalDiskMap(mesh, optionsOf(GetParam()));
    EXPECT_TRUE((map.Positions.array() == first.Positions.array()).all()) << threads;
    EXPECT_TRUE((map.LogFactors.array() == first.LogFactors.array()).all()) << threads;
  }
}

TEST_P(ConformalMethods, OpenFacesWithoutArea)
{
  TriangleMesh mesh = ringMesh(flatDisk(), 500).Mesh;
  // A vertex lies on the middle of a side, and one on another vertex.
  const int m = mesh.vertexCount();
  mesh.Vertices.conservativeResize(m + 2, 3);
  for (const int k : { 0, 1 })
  {
    const int face = 100 + 200 * k;
    const int a = mesh.Faces(face, 0);
    const int b = mesh.Faces(face, 1);
    const int c = mesh.Faces(face, 2);
    mesh.Vertices.row(m + k) = 0.5 * (mesh.Vertices.row(a) + mesh.Vertices.row(k == 0 ? b : a));
    mesh.Faces.row(face) << a, b, m + k;
    mesh.Faces.conservativeResize(mesh.faceCount() + 2, 3);
    mesh.Faces.bottomRows<2>() << b, c, m + k, c, a, m + k;
  }
  const ConformalDiskMap map = conformalDiskMap(mesh, optionsOf(GetParam(), 0));
  expectInDisk(mesh, map);
  EXPECT_GT(map.AddedLength, 0.0);
  EXPECT_LT(map.AddedLength, 1e-7);
  EXPECT_TRUE(map.LogFactors.allFinite());
}

TEST_P(ConformalMethods, RefuseWhatIsNoDisk)
{
  const TriangleMesh disk = ringMesh(flatDisk(), 100).Mesh;
  const auto topologyMessage = [](const TriangleMesh& mesh)
  { return messageOf<TopologyError>([&] { conformalDiskMap(mesh, optionsOf(GetParam())); }); };
  const auto inputMessage = [](const TriangleMesh& mesh, int centre, int boundary)
  {
    return messageOf<InvalidInput>(
      [&] { conformalDiskMap(mesh, optionsOf(GetParam(), centre, boundary)); });
  };
  EXPECT_TRUE(contains(topologyMessage(samples::sphere(2)), "closed"));
  EXPECT_TRUE(contains(topologyMessage(samples::torus(12, 8)), "genus 1"));
  EXPECT_TRUE(contains(topologyMessage(samples::cylinder(12, 4, 1.0)), "2 boundary loops"));
  EXPECT_TRUE(contains(topologyMessage(samples::both(disk, disk)), "2 components"));
  TriangleMesh broken = disk;
  broken.Vertices(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(inputMessage(broken, -1, -1), "vertex 5"));
  broken.Vertices(5, 1) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(contains(inputMessage(broken, -1, -1), "not finite"));
  broken.Vertices.setOnes();
  EXPECT_TRUE(contains(inputMessage(broken, -1, -1), "zero area"));
  EXPECT_TRUE(contains(inputMessage(disk, disk.vertexCount() - 1, -1), "not an interior vertex"));
  EXPECT_TRUE(contains(inputMessage(disk, disk.vertexCount(), -1), "not an interior vertex"));
  EXPECT_TRUE(contains(inputMessage(disk, -1, 0), "not on the boundary"));
}

TEST_P(ConformalMethods, ReportProgressAndCancel)
{
  const TriangleMesh mesh = spherePart(1000).Mesh;
  std::vector<double> fractions;
  conformalDiskMap(mesh,
    optionsOf(GetParam()),
    [&fractions](double fraction, const char*)
    {
      if (fractions.empty() || fraction != fractions.back())
      {
        fractions.push_back(fraction);
      }
      return true;
    });
  ASSERT_GE(fractions.size(), 3u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GE(fractions.front(), 0.0);
  EXPECT_EQ(fractions.back(), 1.0);
  for (const double stop : fractions)
  {
    bool isOver = false;
    EXPECT_THROW(conformalDiskMap(mesh,
                   optionsOf(GetParam()),
                   [&](double fraction, const char*)
                   {
                     EXPECT_FALSE(isOver) << "went on after the stop";
                     isOver = fraction >= stop;
                     return !isOver;
                   }),
      Cancelled);
  }
}

TEST(ConformalDiskMethods, ReportWhileALibraryIsBusy)
{
  const TriangleMesh mesh = spherePart(1000).Mesh;
  for (const auto& [method, stage] : std::vector<std::pair<ConformalMethod, std::string>>{
         { ConformalMethod::RicciFlow, "Ricci flow: preconditioner" },
         { ConformalMethod::RicciFlow, "Layout" },
         { ConformalMethod::BoundaryFirst, "Cotangent Laplacian" },
         { ConformalMethod::BoundaryFirst, "Harmonic extension" },
         { ConformalMethod::MeanValue, "Convex combination map" } })
  {
    SCOPED_TRACE(stage);
    std::unique_ptr<samples::AbandonedCall> busy;
    std::string busyAt;
    int reports = 0;
    const auto progress = [&, wanted = stage](double, const char* now)
    {
      if (!busy && now == wanted)
      {
        busy = std::make_unique<samples::AbandonedCall>();
      }
      if (busy && !busy->isOver() && ++reports == 10) // more than the stage has of its own
      {
        busyAt = now;
        busy->end();
      }
      return true;
    };
    const Points2 positions = conformalDiskMap(mesh, optionsOf(method), progress).Positions;
    EXPECT_EQ(busyAt, stage);
    EXPECT_TRUE(
      (positions.array() == conformalDiskMap(mesh, optionsOf(method)).Positions.array()).all());
  }
}

// Methods without a flat metric report no curvature error.
TEST(ConformalDiskMethods, CurvatureErrorIsOfRicciFlowAlone)
{
  const TriangleMesh mesh = spherePart(500).Mesh;
  EXPECT_LE(conformalDiskMap(mesh).MaxCurvatureError, 1e-10);
  for (const ConformalMethod method : { ConformalMethod::BoundaryFirst, ConformalMethod::MeanValue })
  {
    const ConformalDiskMap map = conformalDiskMap(mesh, optionsOf(method));
    EXPECT_TRUE(std::isnan(map.MaxCurvatureError));
    EXPECT_TRUE(std::isnan(map.LayoutError));
    EXPECT_EQ(map.NewtonIterations, 0);
    EXPECT_EQ(map.BoundaryIterations > 0, method == ConformalMethod::BoundaryFirst);
  }
}

double rootMeanSquare(const Eigen::VectorXd& values)
{
  return values.norm() / std::sqrt(static_cast<double>(values.size()));
}

// The errors of positions and scales on meshes of 2500, 10000 and 40000 vertices.
struct Errors
{
  std::vector<double> Positions;
  std::vector<double> Scales;
};

Errors errorsOnSpherePart(ConformalMethod method)
{
  Errors errors;
  for (const int n : { 2500, 10000, 40000 })
  {
    const SpherePart part = spherePart(n);
    const ConformalDiskMap map = conformalDiskMap(part.Mesh, optionsOf(method, 0, part.Right));
    EXPECT_EQ(map.Untangling.FlippedFaces, 0);
    EXPECT_LE(map.BoundaryIterations, 35) << "of a method that halves the error";
    errors.Positions.push_back(rootMeanSquare((map.Positions - part.Disk).rowwise().norm()));
    errors.Scales.push_back(
      rootMeanSquare((map.LogFactors - part.LogScale).head(part.Right))); // inner vertices
    std::cout << n << " vertices: RMS error of positions " << errors.Positions.back() << ", of scales "
              << errors.Scales.back() << '\n';
  }
  return errors;
}

// Twice the resolution has a quarter of the error, also along the boundary, which is not a circle here.
TEST(BoundaryFirst, ConvergesToTheStereographicProjection)
{
  const Errors errors = errorsOnSpherePart(ConformalMethod::BoundaryFirst);
  EXPECT_LT(errors.Positions[1], 1e-3);
  for (const int k : { 0, 1 })
  {
    EXPECT_LT(errors.Positions[k + 1], errors.Positions[k] / 3.0);
    EXPECT_LT(errors.Scales[k + 1], errors.Scales[k] / 2.0);
  }
}

// The shape of the boundary is not used: finer meshes do not help.
TEST(MeanValue, IsNotConformal)
{
  EXPECT_GT(errorsOnSpherePart(ConformalMethod::MeanValue).Positions.back(), 0.03);
}

// The radii of surfaces of revolution, whose boundary is a circle already.
TEST(BoundaryFirst, ConvergesOnSurfacesOfRevolution)
{
  for (const SurfaceOfRevolution& surface :
    { sphericalCap(0.5 * EIGEN_PI), gaussianBump(1.0, 0.3), capsule(3.0) })
  {
    std::vector<double> errors;
    for (const int n : { 2500, 10000, 40000 })
    {
      const RevolutionMesh mesh = ringMesh(surface, n);
      const ConformalDiskMap map =
        conformalDiskMap(mesh.Mesh, optionsOf(ConformalMethod::BoundaryFirst));
      EXPECT_EQ(map.Untangling.FlippedFaces, 0);
      errors.push_back(radialError(mesh, map.Positions, surface.ConformalRadius));
      std::cout << "RMS error of the radius: " << errors.back() << '\n';
    }
    EXPECT_LT(errors[1], 3e-4);
    EXPECT_LT(errors[1], errors[0] / 3.0);
    EXPECT_LT(errors[2], errors[1] / 3.0);
  }
}

// Every third face gets a vertex at 1e-6 of its size from one of its sides: the intrinsic Delaunay
// triangulation keeps their cotangents from spoiling the map.
TEST(BoundaryFirst, KeepsItsAccuracyOnSlivers)
{
  const SpherePart part = spherePart(5000);
  TriangleMesh slivers = part.Mesh;
  const int n = slivers.vertexCount();
  const int added = slivers.faceCount() / 3;
  slivers.Vertices.conservativeResize(n + added, 3);
  slivers.Faces.conservativeResize(part.Mesh.faceCount() + 2 * added, 3);
  for (int k = 0; k < added; ++k)
  {
    const auto face = part.Mesh.Faces.row(3 * k);
    slivers.Vertices.row(n + k) = 0.3 * part.Mesh.Vertices.row(face[0]) +
                                  (0.7 - 1e-6) * part.Mesh.Vertices.row(face[1]) +
                                  1e-6 * part.Mesh.Vertices.row(face[2]);
    slivers.Faces.row(3 * k) << face[0], face[1], n + k;
    slivers.Faces.row(part.Mesh.faceCount() + 2 * k) << face[1], face[2], n + k;
    slivers.Faces.row(part.Mesh.faceCount() + 2 * k + 1) << face[2], face[0], n + k;
  }
  const ConformalDiskOptions options = optionsOf(ConformalMethod::BoundaryFirst, 0, part.Right);
  const auto error = [&part](const ConformalDiskMap& map)
  { return rootMeanSquare((map.Positions.topRows(part.Disk.rows()) - part.Disk).rowwise().norm()); };
  const ConformalDiskMap map = conformalDiskMap(slivers, options);
  EXPECT_GT(map.Flips, 0);
  EXPECT_LT(error(map), 2.0 * error(conformalDiskMap(part.Mesh, options)));
}

// On a tube of 14 radii the conformal scale falls to 1e-6 of its value at the boundary: the tube's end
// is spread as by the Ricci flow.
TEST(BoundaryFirst, SpreadsTheEndOfATube)
{
  const RevolutionMesh tube = ringMesh(capsule(14.0), 10000);
  const ConformalDiskMap map =
    conformalDiskMap(tube.Mesh, optionsOf(ConformalMethod::BoundaryFirst, -1, tube.FirstBoundaryVertex));
  const ConformalDiskMap expected =
    conformalDiskMap(tube.Mesh, optionsOf(ConformalMethod::RicciFlow, -1, tube.FirstBoundaryVertex));
  ASSERT_GT(expected.SpreadVertices, 100);
  EXPECT_NEAR(map.SpreadVertices, expected.SpreadVertices, 0.02 * expected.SpreadVertices);
  EXPECT_EQ(map.Untangling.FlippedFaces, 0);
  EXPECT_EQ(map.Untangling.RepairedFaces, 0);
  EXPECT_LT(largestDifference(map.Positions, expected.Positions), 1e-3);
  // Next to the pole, where the positions themselves are small.
  EXPECT_NEAR(std::log((map.Positions.row(1) - map.Positions.row(0)).norm()),
    std::log((expected.Positions.row(1) - expected.Positions.row(0)).norm()),
    0.2);
}

// Ricci flow divides a surface of few faces to find a vertex that it can send to infinity. Its vertices
// that are spread are counted, not those of the parts.
TEST(RicciFlow, CountsSpreadVerticesOfTheSurfaceThatWasGiven)
{
  const TriangleMesh needle = surfaceToDisk(samples::meshOf({ { 0.0, 0.0, 0.0 },
                                                              { 0.02, 0.05, 0.0 },
                                                              { 1.0, 0.0, 0.0 },
                                                              { 1.02, 0.05, 0.0 },
                                                              { 2.1, 0.0, 0.0 } },
                                              { { 0, 2, 1 }, { 2, 3, 1 }, { 2, 4, 3 } }))
                                .Surface.Mesh;
  ASSERT_LE(needle.vertexCount(), 100);
  ConformalDiskOptions options;
  options.Method = ConformalMethod::RicciFlow;
  EXPECT_LE(conformalDiskMap(needle, options).SpreadVertices, needle.vertexCount());
}

// The intrinsic Delaunay triangulation of a needle of a few faces has an edge from a boundary vertex to
// itself, around inner vertices whose harmonic images all are that vertex.
TEST(BoundaryFirst, TooCoarseASurfaceIsANamedError)
{
  SurfaceToDiskOptions asItIs;
  asItIs.Hole.BoundaryVertices = 3;
  const TriangleMesh needle = surfaceToDisk(samples::randomSurface(250).Mesh, asItIs).Surface.Mesh;
  ASSERT_LT(needle.vertexCount(), 20);
  const std::string message = messageOf<ConvergenceError>(
    [&] { conformalDiskMap(needle, optionsOf(ConformalMethod::BoundaryFirst)); });
  EXPECT_TRUE(contains(message, "the surface is too coarse there; set Method to Ricci Flow")) << message;
  expectInDisk(needle, conformalDiskMap(needle, optionsOf(ConformalMethod::RicciFlow)));
}

// Tutte's theorem on disks of random shape with random defects and at least as many boundary vertices
// as vtkSurfaceToDiskFilter makes by default.
TEST(MeanValue, FlipsNoFaceOfRandomDisks)
{
  int disks = 0;
  int faces = 0;
  for (int seed = 0; seed < 70; ++seed)
  {
    TriangleMesh mesh;
    try
    {
      mesh = refineBoundary(surfaceToDisk(samples::randomSurface(seed).Mesh).Surface.Mesh, 128).Mesh;
    }
    catch (const FlatteningError&)
    {
      continue; // it cannot be made a disk, which TestRandomSurfaces is about
    }
    const ConformalDiskMap map = conformalDiskMap(mesh, optionsOf(ConformalMethod::MeanValue));
    EXPECT_EQ(map.Untangling.FlippedFaces, 0) << "seed " << seed;
    EXPECT_EQ(map.Untangling.RepairedFaces, 0) << "seed " << seed;
    EXPECT_TRUE(map.Positions.allFinite() && map.LogFactors.allFinite()) << "seed " << seed;
    ++disks;
    faces += mesh.faceCount();
  }
  std::cout << disks << " disks of " << faces << " faces\n";
  EXPECT_GT(disks, 50);
}

} // namespace
