// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "FlatMap/PlanarWarp.h"
#include "Support/RandomNumbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{

using namespace flattening;

// n x n squares of two triangles on [0, 1]^2, at a height.
TriangleMesh square(int n, double height = 7.0)
{
  TriangleMesh mesh;
  mesh.Vertices.resize((n + 1) * (n + 1), 3);
  mesh.Faces.resize(2 * n * n, 3);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const int v = i * (n + 1) + j;
      mesh.Vertices.row(v) << static_cast<double>(j) / n, static_cast<double>(i) / n, height;
      if (i < n && j < n)
      {
        mesh.Faces.row(2 * (i * n + j)) << v, v + 1, v + n + 2;
        mesh.Faces.row(2 * (i * n + j) + 1) << v, v + n + 2, v + n + 1;
      }
    }
  }
  return mesh;
}

Points2 positionsOf(const TriangleMesh& mesh)
{
  return mesh.Vertices.leftCols<2>();
}

// The square onto itself, with more room on the left: area grows by a factor that depends on x alone.
Points2 bent(const Points2& positions)
{
  Points2 result = positions;
  result.col(0) = (1.5 * positions.col(0).array() - 0.5 * positions.col(0).array().square()).matrix();
  return result;
}

Points2 randomPoints(int count)
{
  samples::RandomNumbers random(7);
  Points2 points(count, 2);
  for (int i = 0; i < count; ++i)
  {
    points(i, 0) = random.real(0.0, 1.0);
    points(i, 1) = random.real(0.0, 1.0);
  }
  return points;
}

TEST(PlanarWarp, AnAffineShapeIsReproducedEverywhere)
{
  const TriangleMesh mesh = square(9);
  Eigen::Matrix2d shear;
  shear << 2.0, 0.5, -0.25, 3.0;
  const Points2 to = positionsOf(mesh) * shear;
  const Points2 points = randomPoints(20000);
  const WarpedPoints warped = PlanarWarp(mesh, to).warp(points);
  EXPECT_EQ(std::count(warped.Inside.begin(), warped.Inside.end(), 1), 20000);
  EXPECT_LT((warped.Positions - points * shear).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(PlanarWarp, ThereAndBackIsWhereItWas)
{
  const TriangleMesh mesh = square(40);
  const Points2 to = bent(positionsOf(mesh));
  const Points2 points = randomPoints(100000);
  const WarpedPoints there = PlanarWarp(mesh, to).warp(points);
  const WarpedPoints back = PlanarWarp(mesh, to).warpBack(there.Positions);
  EXPECT_EQ(std::count(back.Inside.begin(), back.Inside.end(), 1), 100000);
  EXPECT_LT((back.Positions - points).cwiseAbs().maxCoeff(), 1e-12);
  // and in between it was where the smooth map puts it, to the mesh's second order: f'' h^2 / 8
  EXPECT_LT((there.Positions - bent(points)).cwiseAbs().maxCoeff(), 1.0 / 40 / 40 / 8 * 1.001);
  EXPECT_GT((there.Positions - points).col(0).maxCoeff(), 0.1);
}

TEST(PlanarWarp, TellsWhatLiesOutside)
{
  const TriangleMesh mesh = square(3);
  Points2 points(6, 2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  points << 0.5, 0.5, 1.0, 1.0, 1.0 + 1e-8, 0.3, 1.001, 0.3, -3.0, 0.0, nan, 0.0;
  const WarpedPoints warped = PlanarWarp(mesh, 2.0 * positionsOf(mesh)).warp(points);
  EXPECT_EQ(warped.Inside, (std::vector<char>{ 1, 1, 1, 0, 0, 0 }));
  EXPECT_EQ(warped.Positions.row(1), Eigen::RowVector2d(2.0, 2.0));
  EXPECT_EQ(warped.Positions.row(4), points.row(4));
}

TEST(PlanarWarp, RefusesWhatIsNoPlanarMesh)
{
  const TriangleMesh mesh = square(3);
  const auto message = [](auto&& body)
  {
    try
    {
      body();
    }
    catch (const InvalidInput& error)
    {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const auto expectRefused = [&](const TriangleMesh& from, const Points2& to, const std::string& words)
  {
    const std::string text = message([&] { PlanarWarp(from, to); });
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  const Points2 positions = positionsOf(mesh);
  Points2 broken = positions;
  broken(3, 1) = std::numeric_limits<double>::infinity();
  expectRefused(mesh, broken, "not finite");
  expectRefused(mesh, positions.topRows(4), "4 flat positions");
  expectRefused({ mesh.Vertices, FaceMatrix(0, 3) }, positions, "no triangles");
  TriangleMesh damaged = mesh;
  damaged.Vertices(3, 1) = std::numeric_limits<double>::quiet_NaN();
  expectRefused(damaged, positions, "not finite");
  TriangleMesh hill = mesh;
  hill.Vertices(5, 2) += 0.01;
  expectRefused(hill, positions, "not planar");
  TriangleMesh folded = mesh;
  folded.Vertices.row(5) << 0.9, 0.9, 7.0; // an inner vertex pulled across others
  expectRefused(folded, positions, "folds over itself");
}

TEST(PlanarWarp, TellsWhichWayTheMeshFaces)
{
  const TriangleMesh mesh = square(3);
  EXPECT_FALSE(PlanarWarp(mesh, positionsOf(mesh)).facesDown());
  const TriangleMesh down{ mesh.Vertices, mesh.Faces.rowwise().reverse() };
  EXPECT_TRUE(PlanarWarp(down, positionsOf(mesh)).facesDown());
}

} // namespace
