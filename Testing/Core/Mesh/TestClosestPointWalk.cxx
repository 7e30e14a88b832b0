// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/ClosestPointTree.h"
#include "Mesh/ClosestPointWalk.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace flattening;

namespace
{

TriangleMesh randomTriangle(std::mt19937& random)
{
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  TriangleMesh mesh;
  mesh.Faces.resize(1, 3);
  mesh.Faces << 0, 1, 2;
  mesh.Vertices.resize(3, 3);
  for (int k = 0; k < 9; ++k)
  {
    mesh.Vertices(k / 3, k % 3) = coordinate(random);
  }
  return mesh;
}

// The distance of a point from a segment.
double distanceFromSegment(const Eigen::Vector3d& a,
  const Eigen::Vector3d& b,
  const Eigen::Vector3d& point)
{
  const double share = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + share * (b - a) - point).norm();
}

// The distance of a point from a triangle: from its plane where the point is above it, otherwise from
// the nearest side.
double distanceFromTriangle(const TriangleMesh& mesh, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d a = mesh.Vertices.row(0);
  const Eigen::Vector3d b = mesh.Vertices.row(1);
  const Eigen::Vector3d c = mesh.Vertices.row(2);
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const auto isInside = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  { return (to - from).cross(point - from).dot(normal) >= 0.0; };
  if (isInside(a, b) && isInside(b, c) && isInside(c, a))
  {
    return std::abs((point - a).dot(normal)) / normal.norm();
  }
  return std::min({ distanceFromSegment(a, b, point),
    distanceFromSegment(b, c, point),
    distanceFromSegment(c, a, point) });
}

} // namespace

// The faces beside an edge are sought around its end that has fewer.
TEST(ClosestPointWalk, SeeksTheFacesOfAnEdgeAroundItsSimplerEnd)
{
  constexpr int spokes = 100;
  TriangleMesh wheel;
  wheel.Faces.resize(spokes, 3);
  wheel.Vertices = Points3::Zero(spokes + 1, 3);
  for (int i = 0; i < spokes; ++i)
  {
    wheel.Faces.row(i) << 0, 1 + i, 1 + (i + 1) % spokes;
    wheel.Vertices.row(1 + i) << std::cos(2.0 * EIGEN_PI * i / spokes),
      std::sin(2.0 * EIGEN_PI * i / spokes), 0.0;
  }
  const VertexFaces around(wheel.Faces, wheel.vertexCount());
  EXPECT_EQ(around.aroundEither(0, 7).size(), 2);
  EXPECT_EQ(around.aroundEither(7, 0).size(), 2);
  EXPECT_EQ(around.aroundEither(0, 0).size(), spokes);
  // From face to face across the spokes.
  const ClosestPointWalk walk(wheel);
  const Eigen::Vector3d point = wheel.Vertices.row(40) * 0.5 + wheel.Vertices.row(41) * 0.25;
  const SurfacePoint closest = walk.closest(point, 0);
  EXPECT_EQ(closest.Face, 39);
  EXPECT_LT((closest.Position - point).norm(), 1e-12);
}

// Random triangles are often obtuse, where the nearest corner is not the one beyond whose side the point
// lies.
TEST(ClosestPointWalk, TheClosestPointOfATriangleIsAtItsDistance)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  for (int trial = 0; trial < 2000; ++trial)
  {
    const TriangleMesh mesh = randomTriangle(random);
    const Eigen::Vector3d point(coordinate(random), coordinate(random), coordinate(random));
    const SurfacePoint closest = ClosestPointWalk(mesh).closest(point, 0);
    const Eigen::Map<const Eigen::RowVector3d> weights(closest.Weights.data());
    ASSERT_NEAR(weights.sum(), 1.0, 1e-12);
    ASSERT_GE(weights.minCoeff(), 0.0);
    ASSERT_LT((weights * mesh.Vertices - closest.Position.transpose()).norm(), 1e-12);
    ASSERT_NEAR((closest.Position - point).norm(), distanceFromTriangle(mesh, point), 1e-9) << trial;
  }
}

TEST(ClosestPointTree, InANeedleThePlaceIsWhereItsWeightsSay)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (const double width : { 1e-3, 1e-8, 1e-12, 1e-15, 1e-16, 0.0 })
  {
    for (int trial = 0; trial < 200; ++trial)
    {
      TriangleMesh mesh = randomTriangle(random);
      const Eigen::RowVector3d aside(coordinate(random), coordinate(random), coordinate(random));
      mesh.Vertices.row(2) = mesh.Vertices.row(0) + width * aside;
      const Eigen::Vector3d point(coordinate(random), coordinate(random), coordinate(random));
      const SurfacePoint closest = ClosestPointTree(mesh).closest(point);
      const Eigen::Map<const Eigen::RowVector3d> weights(closest.Weights.data());
      ASSERT_NEAR(weights.sum(), 1.0, 1e-12);
      ASSERT_GE(weights.minCoeff(), 0.0);
      ASSERT_LT((weights * mesh.Vertices - closest.Position.transpose()).norm(), 1e-8) << width;
    }
  }
}
