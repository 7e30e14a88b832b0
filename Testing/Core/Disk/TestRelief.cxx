// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Disk/ConformalStrain.h"
#include "Disk/ReliefCut.h"
#include "Disk/ReliefPlacement.h"
#include "Mesh/DerivedMesh.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// The part of a sphere of radius 1 above z = 0, whose boundary is moved onto the equator.
TriangleMesh hemisphere(int levels)
{
  TriangleMesh mesh = sphere(levels);
  std::vector<int> above;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    if (faceCorners(mesh, f).col(2).mean() > 0.0)
    {
      above.push_back(f);
    }
  }
  mesh = extractFaces(mesh, above).Mesh;
  for (const int v : requireDisk(mesh))
  {
    mesh.Vertices(v, 2) = 0.0;
    mesh.Vertices.row(v).normalize();
  }
  return mesh;
}

std::vector<char> boundaryFlags(const TriangleMesh& mesh)
{
  std::vector<char> flags(mesh.vertexCount(), 0);
  for (const std::vector<int>& loop : analyseTopology(mesh.Faces, mesh.vertexCount()).BoundaryLoops)
  {
    for (const int v : loop)
    {
      flags[v] = 1;
    }
  }
  return flags;
}

const std::vector<Eigen::Vector3d>& directionsOfBumps()
{
  static const std::vector<Eigen::Vector3d> directions{ { 0.0, 0.0, 1.0 },
    Eigen::Vector3d(1.0, 0.3, -0.2).normalized(),
    Eigen::Vector3d(-0.6, 0.8, -0.3).normalized(),
    Eigen::Vector3d(-0.3, -0.8, -0.5).normalized() };
  return directions;
}

// A sphere with four fingers.
TriangleMesh sphereWithBumps(int levels)
{
  TriangleMesh mesh = sphere(levels);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Eigen::Vector3d x = mesh.Vertices.row(v).transpose().normalized();
    double radius = 1.0;
    for (const Eigen::Vector3d& direction : directionsOfBumps())
    {
      const double angle = std::acos(std::clamp(x.dot(direction), -1.0, 1.0));
      radius += 0.8 * std::exp(-angle * angle / (0.3 * 0.3));
    }
    mesh.Vertices.row(v) = radius * x.transpose();
  }
  return mesh;
}

double distanceFromTips(const PlacedRelief& relief, const Eigen::Vector3d& point)
{
  double nearest = HUGE_VAL;
  for (const Eigen::Vector3d& tip : relief.Tips)
  {
    nearest = std::min(nearest, (tip - point).norm());
  }
  return nearest;
}

// The hemisphere's map is the stereographic projection, of scale 1 / (1 + z) up to a factor that is 1 on
// the equator, and z is spread evenly over the area.
TEST(ConformalStrain, OfAHemisphereIsThatOfTheStereographicProjection)
{
  const double deviation = std::sqrt(2.0 * std::log(2.0) * std::log(2.0) - 4.0 * std::log(2.0) + 2.0 -
                                     std::pow(2.0 * std::log(2.0) - 1.0, 2));
  double before = HUGE_VAL;
  for (const int levels : { 3, 4, 5 })
  {
    const TriangleMesh mesh = hemisphere(levels);
    ConformalStrain strain(mesh);
    strain.open(boundaryFlags(mesh));
    const Eigen::VectorXd& factors = strain.conformalFactors();
    double error = 0.0;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      error = std::max(error, std::abs(factors[v] + std::log1p(mesh.Vertices(v, 2))));
    }
    EXPECT_LT(error, 0.5 * before) << levels;
    before = error;
    if (levels == 5)
    {
      EXPECT_LT(error, 0.01);
      EXPECT_NEAR(strain.strain(), deviation, 0.002); // 0.19773
    }
  }
}

TEST(ConformalStrain, OfDevelopableSurfacesIsNone)
{
  for (const TriangleMesh& mesh : { rectangleGrid(12, 8, 1.5), cylinder(24, 10, 3.0) })
  {
    ConformalStrain strain(mesh);
    strain.open(boundaryFlags(mesh));
    EXPECT_LT(strain.strain(), 1e-12);
  }
}

TEST(ConformalStrain, WithAPathIsThatOfTheSurfaceOpenedThere)
{
  const TriangleMesh mesh = hemisphere(4);
  const std::vector<char> boundary = boundaryFlags(mesh);
  ConformalStrain strain(mesh);
  std::vector<std::vector<int>> paths{ { requireDisk(mesh).front() } }; // which changes nothing
  for (const double angle : { 0.0, 1.0, 2.5 })
  {
    const Eigen::Vector3d across(std::sin(angle), -std::cos(angle), 0.0);
    std::vector<int>& path = paths.emplace_back();
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (std::abs(mesh.Vertices.row(v).dot(across)) < 0.05)
      {
        path.push_back(v);
      }
    }
  }
  strain.open(boundary);
  const std::vector<double> strains = strain.strainsWith(paths);
  ASSERT_EQ(strains.size(), paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    std::vector<char> outline = boundary;
    for (const int v : paths[i])
    {
      outline[v] = 1;
    }
    strain.open(outline);
    EXPECT_NEAR(strains[i], strain.strain(), 1e-12);
    EXPECT_LT(strain.strain(), i == 0 ? 0.2 : 0.1);
  }
}

TEST(ReliefPlacement, FindsTheTipsOfFingers)
{
  for (const int levels : { 4, 5 }) // without and with a coarse copy
  {
    const TriangleMesh mesh = sphereWithBumps(levels);
    const PlacedRelief relief = placeRelief(mesh, {}, {});
    for (const Eigen::Vector3d& direction : directionsOfBumps())
    {
      EXPECT_LT(distanceFromTips(relief, 1.8 * direction), 0.15) << levels;
    }
    EXPECT_GT(relief.StrainBefore, 0.8);
    EXPECT_LT(relief.StrainAfter, 0.35 * relief.StrainBefore);
  }
}

// With a gain of 0 a relief is as long as it may be: its branches are ten edges apart on average, as the
// area is the product of their distance and their length, but for 2.66 square roots of the area.
TEST(ReliefPlacement, BranchesHaveRoomBetweenThem)
{
  ReliefOptions options;
  options.Gain = 0.0;
  for (const int levels : { 3, 4 })
  {
    const TriangleMesh mesh = sphereWithBumps(levels);
    const double unit = std::sqrt(totalArea(mesh));
    const double edge = std::sqrt(4.0 / std::sqrt(3.0) / mesh.faceCount()); // of equilateral triangles
    const double length = cutRelief(mesh, placeRelief(mesh, {}, options).Tips).Opened.Length / unit;
    EXPECT_LT(length, std::max(2.66, 0.1 / edge)) << levels;
    EXPECT_GT(length, levels == 3 ? 2.2 : 3.5);
  }
  options.Longest = 1.5;
  const TriangleMesh mesh = sphereWithBumps(4);
  EXPECT_LT(cutRelief(mesh, placeRelief(mesh, {}, options).Tips).Opened.Length,
    1.5 * std::sqrt(totalArea(mesh)));
}

TEST(ReliefPlacement, BranchesAreWorthTheirLength)
{
  const TriangleMesh mesh = sphereWithBumps(4);
  std::size_t before = 1000;
  for (const double gain : { 0.01, 0.1, 1.0, 1e6 })
  {
    const std::size_t tips = placeRelief(mesh, {}, { gain, 8.0 }).Tips.size();
    EXPECT_LE(tips, before) << gain;
    before = tips;
  }
  EXPECT_EQ(before, 2u); // the first branch opens the surface and is cut in any case
  EXPECT_EQ(placeRelief(mesh, {}, { 0.05, 1e-3 }).Tips.size(), 2u);
  EXPECT_TRUE(placeRelief(hemisphere(4), {}, { 1e6, 8.0 }).Tips.empty());
  EXPECT_TRUE(placeRelief(rectangleGrid(20, 20, 1.0), {}, { 1e-9, 8.0 }).Tips.empty());
}

// More slack gives a shorter relief, which leaves more strain.
TEST(ReliefPlacement, TakesTheShortestWithinTheSlack)
{
  const TriangleMesh mesh = sphereWithBumps(4);
  const PlacedRelief best = placeRelief(mesh, {}, { 0.05, 8.0, 0.0 });
  const PlacedRelief shorter = placeRelief(mesh, {}, { 0.05, 8.0, 0.5 });
  EXPECT_LT(shorter.Tips.size(), best.Tips.size());
  EXPECT_GT(shorter.StrainAfter, best.StrainAfter);
  EXPECT_EQ(placeRelief(mesh, {}, { 0.05, 8.0, 1e6 }).Tips.size(), 2u);
  EXPECT_TRUE(contains(messageOf<InvalidInput>(
                         [&] {
                           placeRelief(mesh, {}, { 0.05, 8.0, -1.0 });
                         }),
    "set it to 0"));
}

// An open surface is cut from its boundary.
TEST(ReliefPlacement, StartsAtTheBoundary)
{
  TriangleMesh mesh = hemisphere(4);
  mesh.Vertices.col(2) *= 3.0;
  const PlacedRelief placed = placeRelief(mesh, {}, { 0.02, 8.0 });
  ASSERT_GE(placed.Tips.size(), 1u);
  EXPECT_LT(placed.StrainAfter, placed.StrainBefore);
  const ReliefOpenedSurface relief = cutRelief(mesh, placed.Tips);
  EXPECT_EQ(relief.Branches, static_cast<int>(placed.Tips.size()));
  EXPECT_GT(requireDisk(relief.Opened.Cut.Surface.Mesh).size(), requireDisk(mesh).size());
  EXPECT_LT(distanceFromTips(placed, { 0.0, 0.0, 3.0 }), 0.3);
}

TEST(ReliefCut, OpensATreeAndLosesNothing)
{
  for (const int levels : { 4, 5 })
  {
    const TriangleMesh mesh = sphereWithBumps(levels);
    const PlacedRelief placed = placeRelief(mesh, {}, {});
    const ReliefOpenedSurface relief = cutRelief(mesh, placed.Tips);
    const TriangleMesh& opened = relief.Opened.Cut.Surface.Mesh;
    const std::vector<int> boundary = requireDisk(opened); // a forest or a loop would leave no disk
    EXPECT_LT(relief.Branches, static_cast<int>(placed.Tips.size())); // fewer where tips are reached
    EXPECT_GE(relief.Branches, static_cast<int>(directionsOfBumps().size()) - 1);
    EXPECT_NEAR(totalArea(opened), totalArea(mesh), 1e-12 * totalArea(mesh));
    double length = 0.0;
    for (std::size_t i = 0; i < boundary.size(); ++i)
    {
      EXPECT_TRUE(relief.Opened.Cut.OnSeam[boundary[i]]);
      length +=
        (opened.Vertices.row(boundary[i]) - opened.Vertices.row(boundary[(i + 1) % boundary.size()]))
          .norm();
    }
    EXPECT_NEAR(length, 2.0 * relief.Opened.Length, 1e-12 * length);
    for (const Eigen::Vector3d& tip : placed.Tips)
    {
      double nearest = HUGE_VAL;
      for (const int v : boundary)
      {
        nearest = std::min(nearest, (opened.Vertices.row(v).transpose() - tip).norm());
      }
      EXPECT_LT(nearest, 0.05);
    }
  }
}

// The region reaches around one of the fingers.
TEST(ReliefCut, KeepsOffARegion)
{
  const TriangleMesh mesh = sphereWithBumps(5);
  std::vector<char> region(mesh.vertexCount(), 0);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    region[v] = mesh.Vertices.row(v).normalized().dot(directionsOfBumps()[1].transpose()) > 0.85;
  }
  const PlacedRelief placed = placeRelief(mesh, region, {});
  const ReliefOpenedSurface relief = cutRelief(mesh, placed.Tips, region);
  const CutSurface& cut = relief.Opened.Cut;
  requireDisk(cut.Surface.Mesh);
  EXPECT_GE(relief.Branches, 2);
  for (int v = 0; v < cut.Surface.Mesh.vertexCount(); ++v)
  {
    for (VertexOrigins::InnerIterator origin(cut.Surface.Vertices, v); origin; ++origin)
    {
      EXPECT_FALSE(cut.OnSeam[v] && region[origin.col()]) << v;
    }
  }
  EXPECT_GT(distanceFromTips(placed, 1.8 * directionsOfBumps()[1]), 0.5);
}

// The geodesic between the tips would cross the region in its middle.
TEST(ReliefCut, LeadsAroundARegion)
{
  const TriangleMesh mesh = sphere(5);
  const Eigen::Vector3d middle(std::cos(1.0), std::sin(1.0), 0.0);
  std::vector<char> region(mesh.vertexCount(), 0);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    region[v] = mesh.Vertices.row(v).dot(middle.transpose()) > std::cos(0.5);
  }
  const ReliefOpenedSurface relief =
    cutRelief(mesh, { { 1.0, 0.0, 0.0 }, { std::cos(2.0), std::sin(2.0), 0.0 } }, region);
  const CutSurface& cut = relief.Opened.Cut;
  requireDisk(cut.Surface.Mesh);
  EXPECT_EQ(relief.Branches, 1);
  double nearest = HUGE_VAL;
  for (int v = 0; v < cut.Surface.Mesh.vertexCount(); ++v)
  {
    if (cut.OnSeam[v])
    {
      nearest = std::min(nearest, std::acos(cut.Surface.Mesh.Vertices.row(v).normalized().dot(middle)));
    }
  }
  EXPECT_GT(nearest, 0.5);
  EXPECT_LT(nearest, 0.65);
  EXPECT_GT(relief.Opened.Length, 2.0);
  EXPECT_LT(relief.Opened.Length, 2.6);
}

TEST(ReliefCut, DoesNotDependOnThreads)
{
  const TriangleMesh mesh = sphereWithBumps(5);
  std::vector<Eigen::Vector3d> tips;
  TriangleMesh first;
  for (const std::size_t threads : { 1, 2, 4 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const PlacedRelief placed = placeRelief(mesh, {}, {});
    const TriangleMesh opened = cutRelief(mesh, placed.Tips).Opened.Cut.Surface.Mesh;
    if (threads == 1)
    {
      tips = placed.Tips;
      first = opened;
    }
    EXPECT_EQ(placed.Tips, tips) << threads;
    EXPECT_EQ(opened.Vertices, first.Vertices) << threads;
    EXPECT_EQ(opened.Faces, first.Faces) << threads;
  }
}

TEST(ReliefPlacement, RejectsWhatLeavesNoRoom)
{
  const TriangleMesh mesh = sphere(3);
  const auto rejection = [&mesh](const std::vector<char>& avoided, const ReliefOptions& options)
  { return messageOf<InvalidInput>([&] { placeRelief(mesh, avoided, options); }); };
  EXPECT_TRUE(contains(rejection(std::vector<char>(mesh.vertexCount(), 1), {}), "covers all"));
  EXPECT_TRUE(contains(rejection({ 1, 0 }, {}), "one flag per vertex"));
  EXPECT_TRUE(contains(rejection({}, { -1.0, 8.0 }), "gain"));
  EXPECT_TRUE(contains(rejection({}, { NAN, 8.0 }), "gain"));
  EXPECT_TRUE(contains(rejection({}, { 0.05, 0.0 }), "longest relief"));
  EXPECT_TRUE(contains(rejection({}, { 0.05, 8.0, -1.0 }), "slack"));
  EXPECT_TRUE(contains(rejection({}, { 0.05, 8.0, 0.0, NAN }), "least strain"));
  std::vector<char> allButOne(mesh.vertexCount(), 1);
  allButOne[7] = 0;
  EXPECT_TRUE(placeRelief(mesh, allButOne, {}).Tips.empty());
  EXPECT_THROW(placeRelief(mesh, {}, {}, [](double, const char*) { return false; }), Cancelled);
  const Eigen::Vector3d tip = mesh.Vertices.row(0);
  const ReliefOpenedSurface uncut = cutRelief(mesh, { tip, tip });
  EXPECT_EQ(uncut.Branches, 0);
  EXPECT_EQ(uncut.Opened.Cut.Surface.Mesh.vertexCount(), mesh.vertexCount());
}

} // namespace
