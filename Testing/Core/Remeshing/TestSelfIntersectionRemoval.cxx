// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshMeasures.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/SelfIntersectionRemoval.h"
#include "Remeshing/SliverRemoval.h"
#include "Support/RandomNumbers.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace flattening;
using namespace flattening::samples;

/// A sheet bent to a U with layers at z = 0 and 2. The lower one has a bump at x = 6, @p height high.
TriangleMesh foldedSheet(double height)
{
  constexpr int Across = 24;
  constexpr int Along = 48;
  constexpr double Step = 0.5;
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i <= Along; ++i)
  {
    for (int j = 0; j <= Across; ++j)
    {
      const double s = Step * i;
      const double y = Step * j;
      const double flat = 12.0 - 0.5 * Pi; // then a half circle of radius 1, and back
      double x = s;
      double z = 0.0;
      if (s > flat)
      {
        const double angle = std::min(s - flat, Pi);
        x = flat + std::sin(angle) - std::max(0.0, s - flat - Pi);
        z = 1.0 - std::cos(angle);
      }
      else
      {
        z = height * std::exp(-(std::pow(x - 6.0, 2) + std::pow(y - 6.0, 2)));
      }
      vertices.push_back({ x, y, z });
    }
  }
  const auto at = [](int i, int j) { return i * (Across + 1) + j; };
  for (int i = 0; i < Along; ++i)
  {
    for (int j = 0; j < Across; ++j)
    {
      faces.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      faces.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return meshOf(vertices, faces);
}

// Smoothing draws in a bump that passes through another sheet; changes of a few faces cannot.
TEST(SelfIntersectionRemoval, DrawsAFoldInThatPassesThroughAnother)
{
  ASSERT_TRUE(selfIntersections(foldedSheet(1.5)).empty());
  const TriangleMesh mesh = foldedSheet(2.6);
  ASSERT_GT(selfIntersections(mesh).size(), 10u);
  MeshOnSurface surface(mesh);
  EXPECT_EQ(removeSelfIntersections(surface), 0);
  const TriangleMesh result = surface.derived().Mesh;
  EXPECT_TRUE(selfIntersections(result).empty());
  EXPECT_GE(smallestAngle(result), 5.0);
  ASSERT_EQ(result.Faces.rows(), mesh.Faces.rows());
  // Only vertices near the bump moved, and not far.
  const Eigen::VectorXd moved = (result.Vertices - mesh.Vertices).rowwise().norm();
  EXPECT_LT(moved.maxCoeff(), 2.6);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (std::hypot(mesh.Vertices(v, 0) - 6.0, mesh.Vertices(v, 1) - 6.0) > 5.0)
    {
      EXPECT_EQ(moved[v], 0.0) << v;
    }
  }
}

TEST(SelfIntersectionRemoval, LeavesSheetsThatOnlyComeNear)
{
  const TriangleMesh mesh = foldedSheet(1.9);
  ASSERT_TRUE(selfIntersections(mesh).empty());
  MeshOnSurface surface(mesh);
  EXPECT_EQ(removeSelfIntersections(surface), 0);
  EXPECT_EQ(surface.derived().Mesh.Vertices, mesh.Vertices);
}

// There is no room on a tube that is pressed flat: it is left as it is, at once.
TEST(SelfIntersectionRemoval, LeavesATubeThatIsPressedFlat)
{
  TriangleMesh tube = cylinder(60, 120, 8.0);
  RandomNumbers random(5);
  for (auto vertex : tube.Vertices.rowwise())
  {
    vertex << 1e-14 * vertex.x(), vertex.y() + random.real(-0.1, 0.1),
      vertex.z() + random.real(-0.1, 0.1);
  }
  MeshOnSurface surface(tube);
  EXPECT_GT(removeSelfIntersections(surface), tube.faceCount() / 10);
  EXPECT_EQ(surface.derived().Mesh.Vertices, tube.Vertices);
}

} // namespace
