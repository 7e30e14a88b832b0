// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Mesh/MeshTopology.h"
#include "Regions/RegionDisk.h"
#include "Regions/RegionExtent.h"
#include "Support/AbandonedCall.h"
#include "Support/MarchingTetrahedra.h"
#include "Support/SampleSurfaces.h"

#include <Eigen/Geometry>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;
using boost::math::quadrature::gauss_kronrod;

// The ellipsoid as an isosurface, with all its slivers, its axes askew to the grid: cut along planes of
// the grid, a region would end with whole rows of triangles.
TriangleMesh ellipsoid(const Eigen::RowVector3d& axes, double spacing)
{
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()) *
                                Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()))
                                 .toRotationMatrix();
  const double half = axes.maxCoeff() / spacing + 3.37;
  const auto size = static_cast<int>(2 * half);
  Volume volume({ size, size, size });
  for (int z = 0; z < size; ++z)
  {
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        const Eigen::RowVector3d p = spacing * (Eigen::RowVector3d(x, y, z).array() - half);
        volume.at(x, y, z) = 1.0 - (p * turn).cwiseQuotient(axes).norm();
      }
    }
  }
  TriangleMesh mesh = marchingTetrahedra(volume);
  mesh.Vertices = spacing * (mesh.Vertices.array() - half).matrix() * turn;
  return mesh;
}

// Faces whose centroid is above a height.
std::vector<char> above(const TriangleMesh& mesh, double height)
{
  std::vector<char> faces(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const auto z = [&](int k) { return mesh.Vertices(mesh.Faces(f, k), 2); };
    faces[f] = (z(0) + z(1) + z(2)) / 3.0 > height;
  }
  return faces;
}

double regionArea(const RegionDisk& disk)
{
  const Eigen::VectorXd areas = faceAreas(disk.Disk.Mesh.Vertices, disk.Disk.Mesh.Faces);
  double sum = 0.0;
  for (Eigen::Index f = 0; f < areas.size(); ++f)
  {
    sum += disk.InRegion[f] ? areas[f] : 0.0;
  }
  return sum;
}

// The arc length of half an ellipse with semi-axes a and b, from tip to tip of a.
double halfEllipse(double a, double b)
{
  return gauss_kronrod<double, 61>::integrate(
    [=](double t) { return std::hypot(a * std::sin(t), b * std::cos(t)); }, 0.0, Pi, 10, 1e-12);
}

double halfEllipsoidArea(const Eigen::RowVector3d& r)
{
  return gauss_kronrod<double, 61>::integrate(
    [&r](double t)
    {
      return gauss_kronrod<double, 61>::integrate(
        [&r, t](double u)
        {
          const double s = std::sin(u);
          return s * std::sqrt(std::pow(r[1] * r[2] * s * std::cos(t), 2) +
                               std::pow(r[0] * r[2] * s * std::sin(t), 2) +
                               std::pow(r[0] * r[1] * std::cos(u), 2));
        },
        0.0,
        0.5 * Pi);
    },
    0.0,
    2.0 * Pi);
}

struct Exact
{
  double Area;
  double Diameter;
  double Across;
  double Perimeter;
};

void expectMeasures(const TriangleMesh& mesh, double height, const Exact& exact, const std::string& name)
{
  SCOPED_TRACE(name);
  const RegionDisk disk = regionDisk(mesh, above(mesh, height), { 2.0 });
  std::vector<int> faces;
  for (std::size_t f = 0; f < disk.InRegion.size(); ++f)
  {
    if (disk.InRegion[f])
    {
      faces.push_back(static_cast<int>(f));
    }
  }
  EXPECT_LT(faces.size(), disk.InRegion.size()); // there is a margin
  const RegionExtent extent = regionExtent(extractFaces(disk.Disk.Mesh, faces).Mesh);
  const auto percent = [](double value, double of) { return 100.0 * (value / of - 1.0); };
  std::printf("%s, %zu faces: area %+.2f %%, diameter %+.2f %%, across %+.2f %%, perimeter %+.2f %% "
              "(jagged %+.1f %%)\n",
    name.c_str(),
    faces.size(),
    percent(regionArea(disk), exact.Area),
    percent(extent.Diameter.Length, exact.Diameter),
    percent(extent.Across.Length, exact.Across),
    percent(extent.Perimeter, exact.Perimeter),
    percent(extent.Outline.Length, exact.Perimeter));
  EXPECT_NEAR(regionArea(disk) / exact.Area, 1.0, 0.01);
  EXPECT_NEAR(extent.Diameter.Length / exact.Diameter, 1.0, 0.02);
  EXPECT_NEAR(extent.Across.Length / exact.Across, 1.0, 0.02);
  EXPECT_NEAR(extent.Perimeter / exact.Perimeter, 1.0, 0.03);
}

TEST(RegionExtent, OfSphericalCapsIsTheClosedForm)
{
  const double radius = 5.0;
  const TriangleMesh ball = ellipsoid(Eigen::RowVector3d::Constant(radius), 0.4);
  for (const double degrees : { 40.0, 60.0, 80.0 })
  {
    const double angle = degrees * Pi / 180.0;
    expectMeasures(ball,
      radius * std::cos(angle),
      { 2.0 * Pi * radius * radius * (1.0 - std::cos(angle)),
        2.0 * radius * angle,
        2.0 * radius * angle,
        2.0 * Pi * radius * std::sin(angle) },
      "cap of " + std::to_string(int(degrees)) + " degrees, radius " + std::to_string(int(radius)));
  }
}

TEST(RegionExtent, OfEllipsoidalPolypsIsTheClosedForm)
{
  for (const Eigen::RowVector3d& axes :
    { Eigen::RowVector3d(6, 4, 3), Eigen::RowVector3d(5, 4, 2), Eigen::RowVector3d(8, 3, 3) })
  {
    expectMeasures(ellipsoid(axes, 0.4),
      0.0,
      { halfEllipsoidArea(axes),
        halfEllipse(axes[0], axes[2]),
        halfEllipse(axes[1], axes[2]),
        2.0 * halfEllipse(axes[0], axes[1]) },
      "half ellipsoid " + std::to_string(int(axes[0])) + ", " + std::to_string(int(axes[1])) + ", " +
        std::to_string(int(axes[2])));
  }
}

// A sheet of n x n unit squares.
TriangleMesh sheet(int n)
{
  TriangleMesh mesh;
  mesh.Vertices.resize((n + 1) * (n + 1), 3);
  mesh.Faces.resize(2 * n * n, 3);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const int v = i * (n + 1) + j;
      mesh.Vertices.row(v) << j, i, 0.0;
      if (i < n && j < n)
      {
        mesh.Faces.row(2 * (i * n + j)) << v, v + 1, v + n + 2;
        mesh.Faces.row(2 * (i * n + j) + 1) << v, v + n + 2, v + n + 1;
      }
    }
  }
  return mesh;
}

// Both triangles of the squares for which the predicate of (column, row) holds.
template <typename Predicate>
std::vector<char> squares(int n, const Predicate& predicate)
{
  std::vector<char> faces(2 * n * n);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      faces[2 * (i * n + j)] = faces[2 * (i * n + j) + 1] = predicate(j, i);
    }
  }
  return faces;
}

bool within(int j, int i, int low, int high)
{
  return j >= low && j < high && i >= low && i < high;
}

TEST(RegionDisk, KeepsTheLargestPieceAndFillsItsHoles)
{
  const int n = 30;
  const TriangleMesh mesh = sheet(n);
  const auto region = squares(n,
    [](int j, int i) { return (within(j, i, 5, 15) && !within(j, i, 8, 10)) || within(j, i, 20, 22); });
  const RegionDisk disk = regionDisk(mesh, region);
  EXPECT_EQ(disk.Pieces, 2);
  EXPECT_EQ(disk.DroppedArea, 4.0);
  EXPECT_EQ(disk.FilledHoles, 1);
  EXPECT_EQ(disk.FilledArea, 4.0);
  EXPECT_EQ(regionArea(disk), 100.0);
  EXPECT_EQ(disk.InRegion.size(), 200u);
  const RegionDisk wide = regionDisk(mesh, region, { 2.0 });
  EXPECT_EQ(regionArea(wide), 100.0);
  const double whole = totalArea(wide.Disk.Mesh);
  EXPECT_GT(whole, 14.0 * 14.0 - 4.0 * 4.0); // but the corners, which are farther than 2
  EXPECT_LE(whole, 14.0 * 14.0);
}

TEST(RegionDisk, SquaresThatMeetAtACornerAreJoinedThere)
{
  const int n = 12;
  const RegionDisk disk = regionDisk(
    sheet(n), squares(n, [](int j, int i) { return within(j, i, 1, 5) || within(j, i, 5, 9); }));
  EXPECT_EQ(disk.Pieces, 1);
  EXPECT_GE(regionArea(disk), 32.0);
  EXPECT_LE(regionArea(disk), 34.0);
}

TEST(RegionDisk, SaysWhatIsNotADisk)
{
  const auto expectMessage = [](const TriangleMesh& mesh,
                               const std::vector<char>& region,
                               const RegionDiskOptions& options,
                               const std::string& words)
  {
    SCOPED_TRACE(words);
    try
    {
      regionDisk(mesh, region, options);
      ADD_FAILURE() << "no exception";
    }
    catch (const FlatteningError& error)
    {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const int n = 20;
  const auto ring = squares(n, [](int j, int i) { return within(j, i, 2, 18) && !within(j, i, 5, 15); });
  expectMessage(sheet(n), ring, {}, "surrounds 1 part of the surface");
  EXPECT_EQ(regionArea(regionDisk(sheet(n), ring, { 0.0, 1.0 })), 256.0);
  expectMessage(sheet(n), squares(n, [](int, int) { return false; }), {}, "has no triangle");
  expectMessage(sheet(n), ring, { -1.0 }, "must not be negative");
  const TriangleMesh ball = sphere(3);
  expectMessage(ball, std::vector<char>(ball.faceCount(), 1), {}, "is closed");
  const TriangleMesh tube = cylinder(20, 10, 3.0);
  std::vector<char> band(tube.faceCount());
  std::vector<char> part(tube.faceCount());
  for (int f = 0; f < tube.faceCount(); ++f)
  {
    band[f] = f / 40 >= 4 && f / 40 < 6; // all around
    part[f] = band[f] && f % 40 < 24;
  }
  expectMessage(tube, band, {}, "2 boundary loops");
  expectMessage(tube, part, { 1.5 }, "choose a smaller margin");
  EXPECT_NO_THROW(regionDisk(tube, part));
}

TEST(RegionExtent, OfARectangleIsItsDiagonalAndWhatIsSquareToIt)
{
  const int n = 40;
  const RegionDisk disk =
    regionDisk(sheet(n), squares(n, [](int j, int i) { return j >= 5 && j < 35 && i >= 10 && i < 14; }));
  const RegionExtent extent = regionExtent(disk.Disk.Mesh);
  EXPECT_NEAR(extent.Diameter.Length, std::hypot(30.0, 4.0), 1.0); // its corners are rounded
  EXPECT_NEAR(extent.Across.Length, 4.0, 0.25);
  EXPECT_EQ(extent.Outline.Length, 68.0);
  EXPECT_NEAR(extent.Perimeter, 68.0, 3.0);
  EXPECT_EQ(extent.EdgeLength, 1.0);
}

TEST(RegionExtent, IsNotShorterThanTheStraightLineOfACoarseStar)
{
  // Straight lines between two points of the boundary, each shortened by how far smoothing moves its
  // ends, are no longer than geodesics up to the smoothed boundary.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> radius(0.3, 1.0);
  for (int star = 0; star < 40; ++star)
  {
    const int count = 11 + star;
    TriangleMesh mesh{ Points3::Zero(count + 1, 3), FaceMatrix(count, 3) };
    std::vector<int> loop;
    for (int v = 0; v < count; ++v)
    {
      const double angle = 2.0 * EIGEN_PI * v / count;
      mesh.Vertices.row(v) << std::cos(angle), std::sin(angle), 0.0;
      mesh.Vertices.row(v) *= radius(random);
      mesh.Faces.row(v) << count, v, (v + 1) % count;
      loop.push_back(v);
    }
    const double length = regionExtent(mesh).Diameter.Length;
    double straight = 0.0;
    for (int a = 0; a < count; ++a)
    {
      for (int b = 0; b < a; ++b)
      {
        const SurfaceCurve line{ { { a, a, 0.0 }, { b, b, 0.0 } }, 0.0 };
        const double trimmed = trimmedLength(mesh.Vertices, line, loop);
        EXPECT_GE(trimmed, 0.0);
        straight = std::max(straight, trimmed);
      }
    }
    EXPECT_GT(length, 0.95 * straight) << "of " << count << " points";
  }
}

// A ball with two horns and a hole on the other side, so that the same vertex of the boundary is the
// nearest to both tips.
TEST(RegionExtent, OfTwoHornsBesideEachOther)
{
  TriangleMesh ball = sphere(4);
  const Eigen::RowVector3d pole = ball.Vertices.row(0);
  const Eigen::RowVector3d rim = ball.Vertices.row(ball.Faces(0, 1));
  const Eigen::RowVector3d meridian = (rim - rim.dot(pole) * pole).normalized();
  const Eigen::RowVector3d aside = pole.cross(meridian);
  std::vector<char> region(ball.faceCount(), 1);
  for (int f = 0; f < ball.faceCount(); ++f)
  {
    region[f] = (ball.Faces.row(f).array() != 0).all();
  }
  const double height = 4.0;
  for (const double angle : { -0.5, 0.5 })
  {
    const Eigen::RowVector3d tip = (-0.5 * pole + std::cos(angle) * meridian + std::sin(angle) * aside);
    for (int v = 0; v < ball.vertexCount(); ++v)
    {
      const Eigen::RowVector3d direction = ball.Vertices.row(v).normalized();
      const double away = std::acos(std::min(1.0, direction.dot(tip.normalized())));
      ball.Vertices.row(v) += height * std::max(0.0, 1.0 - away / 0.4) * direction;
    }
  }
  const RegionExtent extent = regionExtent(regionDisk(ball, region).Disk.Mesh);
  std::printf("two horns: diameter %.3f, across %.3f\n", extent.Diameter.Length, extent.Across.Length);
  EXPECT_GT(extent.Diameter.Length, 1.7 * height); // from tip to tip
  EXPECT_LT(extent.Diameter.Length, 2.0 * height + 1.0);
  EXPECT_GT(extent.Across.Length, 0.0);
  EXPECT_LT(extent.Across.Length, extent.Diameter.Length);
}

void expectSameCurve(const SurfaceCurve& curve, const SurfaceCurve& other)
{
  EXPECT_EQ(curve.Length, other.Length);
  ASSERT_EQ(curve.Points.size(), other.Points.size());
  for (std::size_t i = 0; i < curve.Points.size(); ++i)
  {
    EXPECT_EQ(curve.Points[i].From, other.Points[i].From);
    EXPECT_EQ(curve.Points[i].To, other.Points[i].To);
    EXPECT_EQ(curve.Points[i].Fraction, other.Points[i].Fraction);
  }
}

// No step waits for a library without reports.
TEST(RegionExtent, ReportsWhileALibraryIsBusyWithADistance)
{
  const int n = 40;
  const TriangleMesh region =
    regionDisk(sheet(n), squares(n, [](int j, int i) { return j >= 5 && j < 35 && i >= 10 && i < 14; }))
      .Disk.Mesh;
  const RegionExtent quiet = regionExtent(region);
  // The sweeps by the heat method, which factor matrices, of the one extent and of the other. Geodesics
  // are found without a library.
  for (const double begin : { 0.0, 0.6 })
  {
    SCOPED_TRACE(begin);
    std::unique_ptr<AbandonedCall> busy;
    double busySince = 0.0;
    double before = 0.0;
    int reports = 0;
    const RegionExtent extent = regionExtent(region,
      [&](double fraction, const char*)
      {
        EXPECT_GE(fraction, before);
        before = fraction;
        if (fraction < begin)
        {
          return true;
        }
        if (!busy)
        {
          busySince = fraction;
          busy = std::make_unique<AbandonedCall>();
        }
        if (!busy->isOver() && ++reports == 20) // more than a step has of its own
        {
          EXPECT_EQ(fraction, busySince);
          busy->end();
        }
        return true;
      });
    EXPECT_TRUE(busy && busy->isOver());
    EXPECT_LT(busySince, begin + 0.025); // in this step, not in the next
    expectSameCurve(extent.Diameter, quiet.Diameter);
    expectSameCurve(extent.Across, quiet.Across);
  }
}

} // namespace
