// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Base/Errors.h"
#include "Conformal/ConformalDisk.h"
#include "Conformal/ConformalRectangle.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

namespace
{

using namespace flattening;
using samples::Pi;

// Vertex j * columns + i at (i, j); diagonals in random directions.
TriangleMesh grid(int columns, int rows)
{
  std::mt19937 random(1);
  TriangleMesh mesh;
  mesh.Vertices.resize(columns * rows, 3);
  mesh.Faces.resize(2 * (columns - 1) * (rows - 1), 3);
  int face = 0;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const int v = j * columns + i;
      mesh.Vertices.row(v) << i, j, 0.0;
      if (i + 1 < columns && j + 1 < rows)
      {
        const int square[4] = { v, v + 1, v + columns + 1, v + columns };
        const int turn = static_cast<int>(random() % 2);
        mesh.Faces.row(face++) << square[turn], square[1 + turn], square[2 + turn];
        mesh.Faces.row(face++) << square[turn], square[2 + turn], square[(3 + turn) % 4];
      }
    }
  }
  return mesh;
}

std::vector<int> gridCorners(int columns, int rows)
{
  return { 0, columns - 1, columns * rows - 1, columns * (rows - 1) };
}

// The same with inner vertices moved at random and triangles far from Delaunay.
TriangleMesh unevenGrid(int columns, int rows, double stretch)
{
  TriangleMesh mesh = grid(columns, rows);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  for (int j = 1; j + 1 < rows; ++j)
  {
    for (int i = 1; i + 1 < columns; ++i)
    {
      mesh.Vertices(j * columns + i, 0) += shift(random);
      mesh.Vertices(j * columns + i, 1) += shift(random);
    }
  }
  mesh.Vertices.col(0) *= stretch;
  return mesh;
}

TEST(ConformalRectangle, AFlatRectangleStaysAsItIs)
{
  const double stretch = 3.0;
  const TriangleMesh mesh = unevenGrid(41, 31, stretch);
  ConformalRectangleOptions options;
  options.Corners = gridCorners(41, 31);
  const ConformalRectangleMap result = conformalRectangleMap(mesh, options);
  EXPECT_NEAR(result.Modulus, 40.0 * stretch / 30.0, 1e-9);
  const Points2 expected = mesh.Vertices.leftCols<2>() / 30.0;
  EXPECT_LT((result.Map.Positions - expected).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((result.Map.LogFactors.array() + std::log(30.0)).abs().maxCoeff(), 1e-9);
  EXPECT_LE(result.Map.MaxCurvatureError, 1e-10);
  EXPECT_EQ(result.Map.Untangling.FlippedFaces, 0);
}

TEST(ConformalRectangle, FindsTheCornersOfARectangle)
{
  TriangleMesh mesh = unevenGrid(41, 31, 1.0);
  std::vector<int> corners = rectangleCorners(mesh, requireDisk(mesh));
  std::vector<int> expected = gridCorners(41, 31);
  EXPECT_TRUE(mesh.Vertices(corners[0], 1) == mesh.Vertices(corners[1], 1)) << "the long side is first";
  std::sort(corners.begin(), corners.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(corners, expected);
  mesh.Vertices.col(1) *= 2.0;
  corners = rectangleCorners(mesh, requireDisk(mesh));
  EXPECT_TRUE(mesh.Vertices(corners[0], 0) == mesh.Vertices(corners[1], 0)) << "the long side is first";
}

// The map to a disk shrinks the ends of a strip by exp(-pi length / width), which doubles cannot hold;
// the remedy that the error names works.
TEST(ConformalRectangle, IsTheRemedyForALongStrip)
{
  const TriangleMesh mesh = grid(401, 5);
  try
  {
    conformalDiskMap(mesh);
    ADD_FAILURE() << "no error";
  }
  catch (const ConvergenceError& error)
  {
    EXPECT_NE(std::string(error.what()).find("set Domain to Rectangle"), std::string::npos);
  }
  EXPECT_EQ(conformalRectangleMap(mesh).Map.Untangling.FlippedFaces, 0);
}

// The corners at an end of a strip are much closer than a fortieth of its boundary.
TEST(ConformalRectangle, FindsTheCornersOfAStrip)
{
  for (const int length : { 20, 100, 1000 })
  {
    SCOPED_TRACE(length);
    const int columns = 4 * length + 1;
    TriangleMesh mesh = grid(columns, 5);
    mesh.Vertices *= 0.25;
    const std::vector<int> corners = rectangleCorners(mesh, requireDisk(mesh));
    EXPECT_TRUE(std::is_permutation(corners.begin(), corners.end(), gridCorners(columns, 5).begin()));
    const ConformalRectangleMap result = conformalRectangleMap(mesh);
    EXPECT_NEAR(result.Modulus / length, 1.0, 1e-9);
    EXPECT_EQ(result.Map.Untangling.FlippedFaces, 0);
  }
}

// A cylinder of radius 1 and length L, cut along a line.
TEST(ConformalRectangle, ACutCylinderUnrolls)
{
  constexpr int around = 2001;
  constexpr int along = 12;
  constexpr double length = 3.0;
  TriangleMesh mesh = grid(around, along);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double angle = 2.0 * Pi * mesh.Vertices(v, 0) / (around - 1);
    const double z = length * mesh.Vertices(v, 1) / (along - 1);
    mesh.Vertices.row(v) << std::cos(angle), std::sin(angle), z;
  }
  ConformalRectangleOptions options;
  options.Corners = gridCorners(around, along);
  const ConformalRectangleMap result = conformalRectangleMap(mesh, options);
  EXPECT_NEAR(1.0 / result.Modulus, length / (2.0 * Pi), 1e-6);
  const double perimeter = (around - 1) * 2.0 * std::sin(Pi / (around - 1));
  EXPECT_NEAR(1.0 / result.Modulus, length / perimeter, 1e-10) << "of the prism that the mesh is";
  EXPECT_EQ(result.Map.Untangling.FlippedFaces, 0);
}

// Four boundary points of the disk at angles -a, a, pi - a, pi + a: the elliptic sine maps the
// half-plane, and so the disk, to a rectangle of width 2 K(k) and height K'(k), k = tan(a / 2)^2.
TEST(ConformalRectangle, ModulusOfADiskWithFourCorners)
{
  double previous = HUGE_VAL;
  for (const int vertices : { 1000, 4000, 16000 })
  {
    const analytic::RevolutionMesh disk = analytic::ringMesh(analytic::flatDisk(), vertices);
    const std::vector<int> loop = requireDisk(disk.Mesh);
    const auto vertexAt = [&](double angle)
    {
      const Eigen::RowVector3d there(std::cos(angle), std::sin(angle), 0.0);
      return *std::min_element(loop.begin(),
        loop.end(),
        [&](int a, int b) {
          return (disk.Mesh.Vertices.row(a) - there).norm() < (disk.Mesh.Vertices.row(b) - there).norm();
        });
    };
    const Eigen::RowVector3d corner = disk.Mesh.Vertices.row(vertexAt(0.4));
    const double a = std::atan2(corner.y(), corner.x());
    const int lower = vertexAt(-a);
    ConformalRectangleOptions options;
    options.Corners = { lower, vertexAt(a), vertexAt(Pi - a), vertexAt(Pi + a) };
    const Eigen::RowVector3d below = disk.Mesh.Vertices.row(lower);
    ASSERT_NEAR(std::atan2(below.y(), below.x()), -a, 1e-9) << "the mesh is symmetric";
    const ConformalRectangleMap result = conformalRectangleMap(disk.Mesh, options);
    const double k = std::pow(std::tan(0.5 * a), 2.0);
    const double expected = 2.0 * std::comp_ellint_1(k) / std::comp_ellint_1(std::sqrt(1.0 - k * k));
    const double error = std::abs(result.Modulus / expected - 1.0);
    std::cout << disk.Mesh.vertexCount() << " vertices: modulus " << result.Modulus << ", exactly "
              << expected << '\n';
    EXPECT_LT(error, 0.6 * previous);
    previous = error;
    EXPECT_LE(result.Map.MaxCurvatureError, 1e-10);
    EXPECT_EQ(result.Map.Untangling.FlippedFaces, 0);
    for (const int v : loop)
    {
      const double x = result.Map.Positions(v, 0);
      const double y = result.Map.Positions(v, 1);
      ASSERT_TRUE(x == 0.0 || x == result.Modulus || y == 0.0 || y == 1.0) << v;
    }
  }
  EXPECT_LT(previous, 2e-3);
}

// The surface has the same map when it is rotated in space and numbered otherwise.
TEST(ConformalRectangle, DependsOnTheSurfaceAlone)
{
  TriangleMesh mesh = grid(25, 13);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    mesh.Vertices(v, 2) = std::sin(0.3 * mesh.Vertices(v, 0)) + 0.1 * mesh.Vertices(v, 1);
  }
  const ConformalRectangleMap expected = conformalRectangleMap(mesh);

  std::vector<int> number(mesh.vertexCount());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), std::mt19937(3));
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  TriangleMesh other = mesh;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    other.Vertices.row(number[v]) = (turn * mesh.Vertices.row(v).transpose()).transpose();
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const int g = (f * 7 + 3) % mesh.faceCount();
    for (int k = 0; k < 3; ++k)
    {
      other.Faces(g, k) = number[mesh.Faces(f, k)];
    }
  }
  const ConformalRectangleMap result = conformalRectangleMap(other);
  EXPECT_NEAR(result.Modulus, expected.Modulus, 1e-9);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    ASSERT_LT((result.Map.Positions.row(number[v]) - expected.Map.Positions.row(v)).norm(), 1e-8) << v;
  }
}

void expectRefusal(const TriangleMesh& mesh, const std::vector<int>& corners, const std::string& text)
{
  ConformalRectangleOptions options;
  options.Corners = corners;
  try
  {
    conformalRectangleMap(mesh, options);
    ADD_FAILURE() << "no error: " << text;
  }
  catch (const InvalidInput& error)
  {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(ConformalRectangle, RefusesCornersThatAreNone)
{
  const TriangleMesh mesh = grid(5, 4);
  expectRefusal(mesh, { 0, 4, 19 }, "3 were given");
  expectRefusal(mesh, { 0, 4, 19, 6 }, "vertex 6 is not on the boundary");
  expectRefusal(mesh, { 0, 4, 19, 99 }, "vertex 99 is not on the boundary");
  expectRefusal(mesh, { 0, 4, 4, 15 }, "same boundary vertex");
  expectRefusal(mesh, { 0, 4, 19, 0 }, "same boundary vertex");
  expectRefusal(mesh, { 0, 19, 4, 15 }, "not in the order");
  expectRefusal(mesh, { 0, 15, 19, 4 }, "not in the order");
  EXPECT_NO_THROW(conformalRectangleMap(mesh, { { 19, 15, 0, 4 }, {} })) << "any corner may be first";
  expectRefusal(samples::meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }),
    {},
    "boundary has 3 vertices");
}

// The smallest mesh of all.
TEST(ConformalRectangle, TwoTrianglesAreARectangle)
{
  const TriangleMesh mesh = samples::meshOf(
    { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  const ConformalRectangleMap result = conformalRectangleMap(mesh);
  EXPECT_NEAR(result.Modulus, 2.0, 1e-9);
}

// The corners of a strip are found though its ends are two or three edges wide.
TEST(ConformalRectangle, FindsTheCornersOfNarrowStrips)
{
  for (const auto& [columns, rows] : { std::pair(20, 3), std::pair(100, 3), std::pair(300, 4) })
  {
    TriangleMesh strip = samples::rectangleGrid(columns, rows, columns - 1.0);
    strip.Vertices.col(1) *= (rows - 1.0) * (columns - 1.0) / Pi;
    const ConformalRectangleMap map = conformalRectangleMap(strip);
    EXPECT_NEAR(map.Modulus, (columns - 1.0) / (rows - 1.0), 1e-9 * map.Modulus);
    EXPECT_EQ(map.Map.Untangling.FlippedFaces, 0);
  }
}

} // namespace
