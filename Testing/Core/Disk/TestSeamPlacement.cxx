// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Disk/GeodesicSeam.h"
#include "Disk/SeamPlacement.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace flattening;
using samples::Pi;

// An ellipsoid with half axes 2, 1 and 0.7.
TriangleMesh ellipsoid()
{
  TriangleMesh mesh = samples::sphere(4);
  mesh.Vertices.col(0) *= 2.0;
  mesh.Vertices.col(2) *= 0.7;
  return mesh;
}

SeamOpenedSurface cutAt(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& points)
{
  SeamOpenedSurface opened = cutGeodesicSeam(mesh, { points, 128, {} });
  requireDisk(opened.Cut.Surface.Mesh);
  return opened;
}

// The straight-line distance of the seam's vertices from the flagged vertices.
double distanceFrom(const TriangleMesh& mesh,
  const std::vector<char>& flags,
  const SeamOpenedSurface& opened)
{
  double nearest = HUGE_VAL;
  for (std::size_t s = 0; s < opened.Cut.OnSeam.size(); ++s)
  {
    for (std::size_t v = 0; opened.Cut.OnSeam[s] && v < flags.size(); ++v)
    {
      if (flags[v])
      {
        nearest =
          std::min(nearest, (opened.Cut.Surface.Mesh.Vertices.row(s) - mesh.Vertices.row(v)).norm());
      }
    }
  }
  return nearest;
}

TEST(SeamPlacement, RunsFromEndToEnd)
{
  const TriangleMesh sphere = samples::sphere(4);
  EXPECT_NEAR(cutAt(sphere, placeSeam(sphere)).Length, Pi, 0.1);

  const TriangleMesh mesh = ellipsoid();
  const std::vector<Eigen::Vector3d> points = placeSeam(mesh);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_LT(points[0].x() * points[1].x(), -3.2); // the tips have -4
  // Half the smaller of the ellipses through both tips, by Ramanujan's formula, is 4.43 long.
  EXPECT_NEAR(cutAt(mesh, points).Length, 4.43, 0.3);
}

// Caps at both tips, between which a seam has to stay, and a belt, on one side of which it has to.
TEST(SeamPlacement, KeepsOffARegion)
{
  const TriangleMesh mesh = ellipsoid();
  const double clearance = 0.02 / 1.4 * std::sqrt(faceAreas(mesh.Vertices, mesh.Faces).sum());
  std::vector<char> caps(mesh.vertexCount());
  std::vector<char> belt(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    caps[v] = std::abs(mesh.Vertices(v, 0)) > 1.2;
    belt[v] = std::abs(mesh.Vertices(v, 0)) < 0.3;
  }
  const SeamOpenedSurface free = cutAt(mesh, placeSeam(mesh));
  EXPECT_EQ(distanceFrom(mesh, caps, free), 0.0);
  EXPECT_LT(distanceFrom(mesh, belt, free), 0.01);

  const SeamOpenedSurface between = cutAt(mesh, placeSeam(mesh, caps));
  EXPECT_GT(distanceFrom(mesh, caps, between), clearance);
  EXPECT_GT(between.Length, 2.0);

  const SeamOpenedSurface beside = cutAt(mesh, placeSeam(mesh, belt));
  EXPECT_GT(distanceFrom(mesh, belt, beside), clearance);
  EXPECT_GT(beside.Length, 1.5);
}

TEST(SeamPlacement, DoesNotDependOnTheUnit)
{
  const TriangleMesh mesh = ellipsoid();
  std::vector<char> cap(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    cap[v] = mesh.Vertices(v, 2) > 0.3;
  }
  const std::vector<Eigen::Vector3d> points = placeSeam(mesh, cap);
  for (const double unit : { std::ldexp(1.0, -30), std::ldexp(1.0, 30) })
  {
    TriangleMesh scaled = mesh;
    scaled.Vertices *= unit;
    const std::vector<Eigen::Vector3d> same = placeSeam(scaled, cap);
    ASSERT_EQ(same.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      EXPECT_EQ(same[i], unit * points[i]);
    }
  }
}

TEST(SeamPlacement, NamesARegionThatLeavesNoRoom)
{
  const TriangleMesh mesh = ellipsoid();
  const auto place = [&mesh](const std::vector<char>& flags) { placeSeam(mesh, flags); };
  using samples::contains;
  using samples::messageOf;
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { place(std::vector<char>(5, 0)); }), "5 flags"));
  std::vector<char> all(mesh.vertexCount(), 1);
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { place(all); }), "no room for a seam"));
  all[17] = 0;
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { place(all); }), "no room for a seam"));
}

} // namespace
