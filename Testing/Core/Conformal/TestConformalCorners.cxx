// SPDX-License-Identifier: GPL-3.0-or-later
/// Boundaries with corners, where the map's scale goes to zero or to infinity.
#include "Base/Errors.h"
#include "Conformal/ConformalDisk.h"
#include "Disk/GeodesicSeam.h"
#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace
{

using namespace flattening;
using samples::Pi;

// The triangle (0,0), (1,0), apex with n edges on each side.
TriangleMesh flatTriangle(int n, double apexX, double apexY)
{
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> faces;
  const auto vertex = [](int i, int j) { return i * (i + 1) / 2 + j; };
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      vertices.push_back({ (i - j + j * apexX) / n, j * apexY / n, 0.0 });
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      faces.push_back({ vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1) });
      if (j < i)
      {
        faces.push_back({ vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1) });
      }
    }
  }
  return samples::meshOf(vertices, faces);
}

std::complex<double> at(const ConformalDiskMap& map, int v)
{
  return { map.Positions(v, 0), map.Positions(v, 1) };
}

TEST(ConformalCorners, SharpCornersBecomePartOfTheCircle)
{
  for (const int n : { 1, 4, 16 })
  {
    for (const auto& apex : { std::array<double, 2>{ 0.5, 0.87 }, { 0.0, 1.0 }, { 1.0, 0.36 } })
    {
      SCOPED_TRACE(n);
      SCOPED_TRACE(apex[1]);
      const TriangleMesh mesh = flatTriangle(n, apex[0], apex[1]);
      const ConformalDiskMap map = conformalDiskMap(mesh);
      EXPECT_LE(map.MaxCurvatureError, 1e-10);
      EXPECT_LE(map.LayoutError, 1e-6);
      for (int i = 0; i <= n; ++i)
      {
        EXPECT_NEAR(std::abs(at(map, i * (i + 1) / 2)), 1.0, 1e-15);
      }
    }
  }
}

// The equilateral triangle's centroid goes to the centre, its corners a third of a turn apart, and the
// middles of its sides halfway between them.
TEST(ConformalCorners, EquilateralTriangleKeepsItsSymmetry)
{
  constexpr int n = 24;
  const TriangleMesh mesh = flatTriangle(n, 0.5, std::sqrt(0.75));
  const ConformalDiskMap map = conformalDiskMap(mesh);
  EXPECT_EQ(map.Untangling.FlippedFaces, 0);
  const auto vertex = [](int i, int j) { return i * (i + 1) / 2 + j; };
  const std::complex<double> corners[] = { at(map, 0), at(map, vertex(n, 0)), at(map, vertex(n, n)) };
  const std::complex<double> middles[] = {
    at(map, vertex(n / 2, 0)), at(map, vertex(n, n / 2)), at(map, vertex(n / 2, n / 2))
  };
  const std::complex<double> third = std::polar(1.0, 2.0 * Pi / 3.0);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_LT(std::abs(corners[(k + 1) % 3] - third * corners[k]), 1e-3) << k;
    EXPECT_LT(std::abs(middles[k] - std::polar(1.0, Pi / 3.0) * corners[k]), 1e-3) << k;
  }
  EXPECT_LT(std::abs(at(map, vertex(2 * n / 3, n / 3))), 1e-3);
}

// The unit sphere cut along an arc of a great circle of +-halfAngle about (1, 0, 0), in the disk: by
// stereographic projection from (-1, 0, 0) a plane cut along a segment, which Joukowski's map takes to
// the outside of the disk.
std::complex<double> slitSphereInDisk(const Eigen::RowVector3d& p, double halfAngle)
{
  const std::complex<double> z =
    std::complex<double>(p[1], p[2]) / ((1.0 + p[0]) * std::tan(0.5 * halfAngle));
  const std::complex<double> root = std::sqrt(z * z - 1.0);
  return 1.0 / (std::abs(z + root) > std::abs(z - root) ? z + root : z - root);
}

// The two sides of a seam coincide, and its ends are corners of 360 degrees.
TEST(ConformalCorners, SeamOpensIntoTheCircle)
{
  for (const double halfAngle : { 0.4, 1.5 })
  {
    SCOPED_TRACE(halfAngle);
    const double c = std::cos(halfAngle);
    const double s = std::sin(halfAngle);
    const SeamOpenedSurface opened =
      cutGeodesicSeam(samples::sphere(4), { { { c, -s, 0 }, { 1, 0, 0 }, { c, s, 0 } }, 64, {} });
    const TriangleMesh& mesh = opened.Cut.Surface.Mesh;
    const auto nearest = [&mesh](const Eigen::Vector3d& p)
    {
      Eigen::Index v = 0;
      (mesh.Vertices.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff(&v);
      return static_cast<int>(v);
    };
    const int centre = nearest({ -0.6, 0.0, 0.8 });
    const int tip = nearest({ c, s, 0 });
    const ConformalDiskMap map = conformalDiskMap(mesh, { centre, tip, {} });
    EXPECT_LE(map.MaxCurvatureError, 1e-10);

    const std::complex<double> zero = slitSphereInDisk(mesh.Vertices.row(centre), halfAngle);
    const auto moved = [zero](std::complex<double> z)
    { return (z - zero) / (1.0 - std::conj(zero) * z); };
    std::vector<char> onBoundary(mesh.vertexCount(), 0);
    for (const int v : requireDisk(mesh))
    {
      onBoundary[v] = 1;
    }
    double error = 0.0;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (!onBoundary[v])
      {
        const std::complex<double> expected =
          moved(slitSphereInDisk(mesh.Vertices.row(v).normalized(), halfAngle)) / moved(1.0);
        error = std::max(error, std::abs(at(map, v) - expected));
      }
    }
    EXPECT_LT(error, 0.05);
  }
}

// Three rows of n points a unit apart, whose triangles are fans from the ends of the rows, or squares
// with a diagonal.
TriangleMesh strip(int n, double height, bool isOfFans)
{
  std::vector<std::array<double, 3>> vertices;
  for (int row = 0; row < 3; ++row)
  {
    for (int i = 0; i < n; ++i)
    {
      vertices.push_back({ static_cast<double>(i), height * row, 0.0 });
    }
  }
  std::vector<std::array<int, 3>> faces;
  for (const int a : { 0, n })
  {
    const int b = a + n;
    for (int i = 0; i + 1 < n; ++i)
    {
      faces.push_back({ isOfFans ? a : a + i, b + i + 1, b + i });
      faces.push_back({ a + i, a + i + 1, isOfFans ? b + n - 1 : b + i + 1 });
    }
  }
  return samples::meshOf(vertices, faces);
}

// Two triangulations of one surface have one map by the harmonic method, whose triangulation is made
// Delaunay first. The fans need 22,076 flips, more than ten for each half-edge.
TEST(ConformalStrips, FansHaveTheMapOfTheirSurface)
{
  ConformalDiskOptions options;
  options.Method = ConformalMethod::BoundaryFirst;
  const ConformalDiskMap expected = conformalDiskMap(strip(150, 10.0, false), options);
  const ConformalDiskMap map = conformalDiskMap(strip(150, 10.0, true), options);
  EXPECT_GT(map.Flips, 20000);
  EXPECT_LT((map.Positions - expected.Positions).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ConformalStrips, FlipsOfFansCanBeCancelled)
{
  const TriangleMesh fans = strip(1000, 60.0, true);
  int reports = 0;
  const ProgressCallback stopLater = [&reports](double, const char*) { return ++reports < 10; };
  EXPECT_THROW(IntrinsicTriangulation(fans).flipToDelaunay(stopLater), Cancelled);
}

// A square of 20 x 20 edges, on whose side a flap of 20 x 20 edges hangs by a neck 2 wide and 12 long.
// On the circle, the conformal map gives the flap an arc of about exp(-pi 12 / 2), 1e-8.
TEST(ConformalFlap, IsSpreadAlongTheCircle)
{
  const int columns = 53;
  const auto isInside = [](int i, int j)
  { return i >= 0 && j >= 0 && j < 20 && (i < 20 || (i < 32 && (j == 9 || j == 10)) || i >= 32); };
  std::vector<int> number(columns * 21, -1);
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j <= 20; ++j)
    {
      const bool isUsed = (i < columns - 1 && (isInside(i, j) || isInside(i, j - 1))) ||
                          isInside(i - 1, j) || isInside(i - 1, j - 1);
      if (isUsed)
      {
        number[i * 21 + j] = static_cast<int>(vertices.size());
        vertices.push_back({ static_cast<double>(i), static_cast<double>(j), 0.0 });
      }
    }
  }
  for (int i = 0; i + 1 < columns; ++i)
  {
    for (int j = 0; j < 20; ++j)
    {
      if (isInside(i, j))
      {
        const int a = number[i * 21 + j];
        const int b = number[(i + 1) * 21 + j];
        const int c = number[(i + 1) * 21 + j + 1];
        const int d = number[i * 21 + j + 1];
        faces.push_back({ a, b, c });
        faces.push_back({ a, c, d });
      }
    }
  }
  const TriangleMesh flap = samples::meshOf(vertices, faces);
  const int corner = number[0];
  for (const auto method : { ConformalMethod::RicciFlow, ConformalMethod::BoundaryFirst })
  {
    ConformalDiskOptions options;
    options.Method = method;
    options.CenterVertex = number[10 * 21 + 10];
    options.BoundaryVertex = corner;
    const ConformalDiskMap map = conformalDiskMap(flap, options);
    EXPECT_GT(map.SpreadVertices, 300);
    EXPECT_EQ(map.Untangling.FlippedFaces, 0);
    // The boundary goes once around the circle, in steps that doubles tell apart.
    const std::vector<int> loop = requireDisk(flap);
    double turn = 0.0;
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      const std::complex<double> step = at(map, loop[(k + 1) % loop.size()]) / at(map, loop[k]);
      EXPECT_GT(std::arg(step), 1e-13) << "at vertex " << loop[k];
      turn += std::arg(step);
    }
    EXPECT_NEAR(turn, 2.0 * Pi, 1e-9);
  }
}

} // namespace
