// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/SurfaceComponents.h"
#include "Remeshing/IsotropicRemeshing.h"
#include "Repair/HoleFilling.h"
#include "Support/SampleSurfaces.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

std::vector<std::vector<int>> loopsOf(const TriangleMesh& mesh)
{
  return analyseTopology(mesh.Faces, mesh.vertexCount()).BoundaryLoops;
}

TEST(HoleFilling, CapsACylinder)
{
  const TriangleMesh open = cylinder(64, 10, 2.0);
  const FilledSurface filled = fillHoles(open, loopsOf(open));
  const TriangleMesh& mesh = filled.Surface.Mesh;
  EXPECT_TRUE(loopsOf(mesh).empty());
  EXPECT_EQ(filled.FilledHoles, 2);
  EXPECT_EQ(filled.IntersectingPatches, 0);
  const double polygon = 0.5 * 64 * std::sin(2.0 * Pi / 64);
  EXPECT_NEAR(filled.FilledArea, 2.0 * polygon, 1e-12);
  EXPECT_NEAR(enclosedVolume(mesh), 2.0 * polygon, 1e-12);
}

// A patch of one face would have the same corners, and splitting an edge of both would make the same
// edge twice.
TEST(HoleFilling, ClosesATriangleWithMoreThanItself)
{
  TriangleMesh triangle;
  triangle.Vertices.resize(3, 3);
  triangle.Vertices << 0, 0, 0, 3, 0, 0, 0, 3, 0;
  triangle.Faces.resize(1, 3);
  triangle.Faces << 0, 1, 2;
  const FilledSurface filled = fillHoles(triangle, loopsOf(triangle));
  EXPECT_EQ(filled.Surface.Mesh.vertexCount(), 4);
  EXPECT_EQ(filled.Surface.Mesh.faceCount(), 4);
  EXPECT_NEAR(filled.FilledArea, 4.5, 1e-12);
  const DerivedMesh remeshed = remeshIsotropically(filled.Surface.Mesh, 0.5);
  EXPECT_TRUE(loopsOf(remeshed.Mesh).empty());
  EXPECT_LT(remeshed.Mesh.faceCount(), 200);
}

TEST(HoleFilling, RefusesALoopThatIsTooLong)
{
  const TriangleMesh open = moved(cylinder(64, 10, 2.0), 5.0, 0.0, 0.0);
  const double length = 64 * 2.0 * std::sin(Pi / 64);
  EXPECT_EQ(fillHoles(open, loopsOf(open), 1.001 * length).FilledHoles, 2);
  const std::string message =
    messageOf<InvalidInput>([&] { fillHoles(open, loopsOf(open), 0.999 * length); });
  EXPECT_TRUE(contains(message, "(5, ")) << message;
  EXPECT_TRUE(contains(message, "6.28")) << message;
  EXPECT_TRUE(contains(message, "raise Fill Length Limit")) << message;
}

// A spike passes through the opening, so that every patch intersects it. A spike beyond the plane of the
// opening must not matter.
TEST(HoleFilling, CountsPatchesThatIntersectTheSurface)
{
  const TriangleMesh open = cylinder(64, 10, 2.0);
  TriangleMesh spike = sphere(2);
  spike.Vertices *= 0.2;
  const TriangleMesh pierced = both(open, moved(spike, 0.0, 0.0, 2.0));
  const FilledSurface filled = fillHoles(pierced, loopsOf(pierced));
  EXPECT_TRUE(loopsOf(filled.Surface.Mesh).empty());
  EXPECT_GT(countSelfIntersections(filled.Surface.Mesh), 0u);
  EXPECT_EQ(filled.IntersectingPatches, 1);
  const TriangleMesh beside = both(open, moved(spike, 0.0, 0.0, 2.5));
  EXPECT_EQ(fillHoles(beside, loopsOf(beside)).IntersectingPatches, 0);
}

// A cylinder and a ring. Spikes pass through both ends of the ring, or lie beyond them.
TriangleMesh cylinderBesideARing(bool isPierced)
{
  TriangleMesh spike = sphere(2);
  spike.Vertices *= 0.2;
  const TriangleMesh ring = moved(cylinder(32, 4, 1.0), 5.0, 0.0, 0.0);
  const TriangleMesh open = both(cylinder(64, 10, 2.0), ring);
  const double beyond = isPierced ? 0.0 : 1.0;
  return both(both(open, moved(spike, 5.0, 0.0, -beyond)), moved(spike, 5.0, 0.0, 1.0 + beyond));
}

// Every kind of patch is tried for the two pierced holes; the two others are filled once.
TEST(HoleFilling, FillsOtherHolesOnceWhereSomeArePierced)
{
  for (const bool isPierced : { false, true })
  {
    const TriangleMesh open = cylinderBesideARing(isPierced);
    int reports = 0;
    double last = 0.0;
    const auto count = [&](double fraction, const char*)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      ++reports;
      return true;
    };
    const FilledSurface filled = fillHoles(open, loopsOf(open), 100.0, count);
    EXPECT_TRUE(loopsOf(filled.Surface.Mesh).empty());
    EXPECT_EQ(filled.FilledHoles, 4);
    EXPECT_EQ(filled.IntersectingPatches, isPierced ? 2 : 0);
    EXPECT_EQ(reports, isPierced ? 4 + 3 * 2 : 4) << "one for each patch";
  }
}

// A pyramid without its base, whose four rim vertices lie alternately above and below the plane z = 0.
TriangleMesh pyramidWithSaddleRim(double height)
{
  TriangleMesh open;
  open.Vertices.resize(5, 3);
  open.Vertices << 1, 0, height, 0, 1, -height, -1, 0, height, 0, -1, -height, 0, 0, -3;
  open.Faces.resize(4, 3);
  open.Faces << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
  return open;
}

// Two triangles cover the hole and have a diagonal in common; a ball around the middle of either
// diagonal leaves the way free for another patch.
TEST(HoleFilling, GoesRoundAnObstacle)
{
  const TriangleMesh open = pyramidWithSaddleRim(0.5);
  int obstacles = 0; // in the way of the patch that the hole gets without a ball
  for (const double z : { 0.5, -0.5 })
  {
    TriangleMesh ball = sphere(1);
    ball.Vertices *= 0.1;
    ball = moved(ball, 0.0, 0.0, z);
    obstacles +=
      countSelfIntersections(both(fillHoles(open, loopsOf(open)).Surface.Mesh, ball)) > 0 ? 1 : 0;
    const TriangleMesh withBall = both(open, ball);
    const FilledSurface filled = fillHoles(withBall, loopsOf(withBall));
    EXPECT_TRUE(loopsOf(filled.Surface.Mesh).empty());
    EXPECT_EQ(filled.IntersectingPatches, 0) << z;
    EXPECT_EQ(countSelfIntersections(filled.Surface.Mesh), 0u) << z;
  }
  EXPECT_EQ(obstacles, 1);
}

// An open cylinder, the ends of which are saddles, far from any plane.
TriangleMesh cylinderBetweenSaddles(int around)
{
  TriangleMesh open = cylinder(around, 10, 2.0);
  open.Vertices.col(2) +=
    0.6 * (open.Vertices.col(0).array().square() - open.Vertices.col(1).array().square()).matrix();
  return open;
}

// Many triangulations of a symmetric hole are equally good, and among them CGAL's search in a Delaunay
// triangulation chooses by addresses. A hole of 512 vertices has more than are searched at once.
TEST(HoleFilling, GivesTheSameWhereverMemoryIsAllocated)
{
  for (const int around : { 64, 512 })
  {
    const TriangleMesh open = cylinderBetweenSaddles(around);
    const FilledSurface first = fillHoles(open, loopsOf(open));
    std::mt19937 random(5);
    std::vector<std::vector<char>> blocks(1000);
    for (int repetition = 0; repetition < (around > 64 ? 3 : 30); ++repetition)
    {
      for (int i = 0; i < 1000; ++i)
      {
        blocks[random() % blocks.size()] =
          std::vector<char>(random() % (random() % 20 == 0 ? 50000 : 500));
      }
      const FilledSurface again = fillHoles(open, loopsOf(open));
      ASSERT_EQ(again.Surface.Mesh.Faces, first.Surface.Mesh.Faces);
      ASSERT_EQ(again.Surface.Mesh.Vertices, first.Surface.Mesh.Vertices);
    }
  }
}

// A hole with more vertices than are searched at once gets a patch by way of a coarse polygon.
TEST(HoleFilling, LongHolesGetPatchesLikeShortOnes)
{
  const TriangleMesh coarse = cylinderBetweenSaddles(100);
  const double shortArea = fillHoles(coarse, loopsOf(coarse)).FilledArea;
  for (const int around : { 501, 700, 2000 })
  {
    const TriangleMesh open = cylinderBetweenSaddles(around);
    const FilledSurface filled = fillHoles(open, loopsOf(open));
    EXPECT_TRUE(loopsOf(filled.Surface.Mesh).empty()) << around;
    EXPECT_EQ(filled.IntersectingPatches, 0) << around;
    EXPECT_NEAR(filled.FilledArea, shortArea, 0.02 * shortArea) << around;
    EXPECT_EQ(analyseTopology(filled.Surface.Mesh.Faces, filled.Surface.Mesh.vertexCount()).Genus, 0);
  }
}

ComponentChoice byIndex(int index)
{
  ComponentChoice choice;
  choice.By = ComponentChoice::Rule::ByIndex;
  choice.Index = index;
  return choice;
}

TEST(SurfaceComponents, AreRankedByArea)
{
  TriangleMesh large = sphere(3);
  large.Vertices *= 2.0;
  const TriangleMesh mesh = both(both(moved(tetrahedron(), 9, 0, 0), moved(sphere(2), -9, 0, 0)), large);
  const SurfaceComponents components = connectedComponents(mesh);
  ASSERT_EQ(components.Count, 3);
  EXPECT_EQ(chooseComponent(mesh, components, byIndex(0)), 2);
  EXPECT_EQ(chooseComponent(mesh, components, byIndex(1)), 1);
  EXPECT_EQ(chooseComponent(mesh, components, byIndex(2)), 0);
  const Eigen::VectorXd areas = componentAreas(mesh, components);
  ASSERT_EQ(areas.size(), 3);
  EXPECT_NEAR(areas[0], 1.5 + std::sqrt(3.0) / 2.0, 1e-14);
  EXPECT_EQ((areas.array() >= 0.1 * areas.sum()).count(), 2);
  EXPECT_EQ((areas.array() >= 0.5 * areas.sum()).count(), 1);
  const std::string message =
    messageOf<InvalidInput>([&] { chooseComponent(mesh, components, byIndex(3)); });
  EXPECT_TRUE(contains(message, "has 3")) << message;
  EXPECT_THROW(chooseComponent(mesh, components, byIndex(-1)), InvalidInput);
}

TEST(SurfaceComponents, AreFoundFromFarAway)
{
  const TriangleMesh mesh = both(sphere(2), moved(sphere(2), 9, 0, 0));
  const SurfaceComponents components = connectedComponents(mesh);
  ComponentChoice choice;
  choice.By = ComponentChoice::Rule::ClosestToPoint;
  for (const double distance : { 20.0, 1e100, 1e150 })
  {
    choice.Point = { distance, 0.0, 0.0 };
    EXPECT_EQ(chooseComponent(mesh, components, choice), components.OfFace[mesh.faceCount() - 1]);
  }
  for (const double distance : { 1e154, -1e306 })
  {
    choice.Point = { distance, distance, 0.0 };
    EXPECT_TRUE(
      contains(messageOf<InvalidInput>([&] { chooseComponent(mesh, components, choice); }), "so far"));
  }
}

} // namespace
