// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/EigenVersions.h"
#include "Base/Errors.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/ClosestPointWalk.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/IsotropicRemeshing.h"
#include "Remeshing/SliverRemoval.h"
#include "Support/SampleSurfaces.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// A sphere with every fourth face split at a point next to a corner or an edge, which makes needles and
// caps.
TriangleMesh sphereWithSlivers()
{
  TriangleMesh mesh = sphere(4);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const int faces = mesh.faceCount();
  const int vertices = mesh.vertexCount();
  mesh.Vertices.conservativeResize(vertices + faces / 4, 3);
  mesh.Faces.conservativeResize(faces + 2 * (faces / 4), 3);
  for (int i = 0; i < faces / 4; ++i)
  {
    const int f = 4 * i;
    const Eigen::RowVector3i t = mesh.Faces.row(f);
    const double s = 1e-5 + 0.2 * share(random); // share of the second corner
    const double r = i % 2 ? 1e-5 : 0.4;
    mesh.Vertices.row(vertices + i) = (1.0 - s - r) * mesh.Vertices.row(t[0]) +
                                      s * mesh.Vertices.row(t[1]) + r * mesh.Vertices.row(t[2]);
    mesh.Faces.row(f) << t[0], t[1], vertices + i;
    mesh.Faces.row(faces + 2 * i) << t[1], t[2], vertices + i;
    mesh.Faces.row(faces + 2 * i + 1) << t[2], t[0], vertices + i;
  }
  return mesh;
}

double greatestDistance(const TriangleMesh& from, const TriangleMesh& to)
{
  const ClosestPointTree projection(to);
  double greatest = 0.0;
  for (int v = 0; v < from.vertexCount(); ++v)
  {
    const Eigen::Vector3d point = from.Vertices.row(v);
    greatest = std::max(greatest, (projection.closest(point).Position - point).norm());
  }
  return greatest;
}

// The mean over the faces of their smallest angles, in degrees.
double meanSmallestAngle(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    TriangleMesh face;
    face.Vertices = mesh.Vertices(mesh.Faces.row(f), flattening::all);
    face.Faces.resize(1, 3);
    face.Faces << 0, 1, 2;
    sum += smallestAngle(face);
  }
  return sum / mesh.faceCount();
}

TEST(SliverRemoval, SmallestAngleOfKnownTriangles)
{
  EXPECT_NEAR(smallestAngle(tetrahedron()), 45.0, 1e-12);
  EXPECT_NEAR(smallestAngle(icosahedron()), 60.0, 1e-12);
  const double angle = 1e-7;
  const TriangleMesh needle =
    meshOf({ { 0, 0, 0 }, { 1e9, 0, 0 }, { 1e9, 1e9 * angle, 0 } }, { { 0, 1, 2 } });
  EXPECT_NEAR(smallestAngle(needle) / (angle * 180.0 / Pi), 1.0, 1e-9);
}

TEST(IsotropicRemeshing, SliversBecomeNearlyEquilateral)
{
  const TriangleMesh input = sphereWithSlivers();
  ASSERT_LT(smallestAngle(input), 0.01);
  const double length = meanEdgeLength(sphere(4));
  const DerivedMesh remeshed = remeshIsotropically(input, length);
  const MeshTopology topology = analyseTopology(remeshed.Mesh.Faces, remeshed.Mesh.vertexCount());
  EXPECT_EQ(topology.eulerCharacteristic(), 2);
  EXPECT_TRUE(topology.BoundaryLoops.empty());
  EXPECT_GT(smallestAngle(remeshed.Mesh), 15.0);
  EXPECT_GT(meanSmallestAngle(remeshed.Mesh), 55.0); // 56.8, and 53.8 if vertices are not relaxed
  EXPECT_NEAR(meanEdgeLength(remeshed.Mesh) / length, 1.0, 0.1);
  EXPECT_NEAR(totalArea(remeshed.Mesh) / totalArea(input), 1.0, 1e-3);
  EXPECT_LT(greatestDistance(remeshed.Mesh, input), 1e-12); // vertices are on the surface
  EXPECT_LT(greatestDistance(input, remeshed.Mesh), 0.4 * length * length); // the sagitta of a face
  EXPECT_EQ(countSelfIntersections(remeshed.Mesh), 0u);
  const Points3 traced = remeshed.Vertices * input.Vertices;
  EXPECT_LT((traced - remeshed.Mesh.Vertices).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(*std::min_element(remeshed.Faces.begin(), remeshed.Faces.end()) >= 0, true);
}

TEST(SliverRemoval, OpensSliversAndKeepsTheRest)
{
  const TriangleMesh input = sphereWithSlivers();
  const DerivedMesh opened = withoutSmallAngles(input, 5.0);
  EXPECT_GT(smallestAngle(opened.Mesh), 5.0);
  EXPECT_EQ(analyseTopology(opened.Mesh.Faces, opened.Mesh.vertexCount()).eulerCharacteristic(), 2);
  EXPECT_NEAR(totalArea(opened.Mesh) / totalArea(input), 1.0, 1e-3);

  const TriangleMesh sound = sphere(3);
  const DerivedMesh same = withoutSmallAngles(sound, 30.0);
  EXPECT_EQ(same.Mesh.Faces.rows(), sound.Faces.rows());
  EXPECT_EQ(same.Mesh.Vertices, sound.Vertices);
  for (int f = 0; f < sound.faceCount(); ++f)
  {
    EXPECT_EQ(same.Faces[f], f);
  }
}

TEST(IsotropicRemeshing, KeepsTheBoundary)
{
  const TriangleMesh input = cylinder(200, 5, 1.0); // long narrow faces
  const DerivedMesh remeshed = remeshIsotropically(input, 0.1);
  const MeshTopology topology = analyseTopology(remeshed.Mesh.Faces, remeshed.Mesh.vertexCount());
  EXPECT_EQ(topology.Genus, 0);
  ASSERT_EQ(topology.BoundaryLoops.size(), 2u);
  for (const std::vector<int>& loop : topology.BoundaryLoops)
  {
    for (const int v : loop)
    {
      const Eigen::RowVector3d p = remeshed.Mesh.Vertices.row(v);
      EXPECT_TRUE(p[2] == 0.0 || p[2] == 1.0);
      EXPECT_NEAR(p.head<2>().norm(), 1.0, 0.005);
    }
  }
  EXPECT_GT(smallestAngle(remeshed.Mesh), 10.0);
  EXPECT_NEAR(totalArea(remeshed.Mesh) / totalArea(input), 1.0, 5e-3);
}

// Faces with two boundary edges, by their number.
std::vector<int> earsOf(const TriangleMesh& mesh)
{
  std::map<std::pair<int, int>, int> sides;
  const auto sideOf = [&mesh](int f, int k) -> std::pair<int, int>
  { return std::minmax(mesh.Faces(f, k), mesh.Faces(f, (k + 1) % 3)); };
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      ++sides[sideOf(f, k)];
    }
  }
  std::vector<int> ears;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    int boundary = 0;
    for (int k = 0; k < 3; ++k)
    {
      boundary += sides[sideOf(f, k)] == 1 ? 1 : 0;
    }
    if (boundary >= 2)
    {
      ears.push_back(f);
    }
  }
  return ears;
}

// In a square of two triangles, at two corners of a grid, and along a side with teeth.
TEST(IsotropicRemeshing, LeavesNoFaceWithTwoBoundaryEdges)
{
  TriangleMesh square;
  square.Vertices.resize(4, 3);
  square.Vertices << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  square.Faces.resize(2, 3);
  square.Faces << 0, 1, 2, 0, 2, 3;
  const TriangleMesh grid = rectangleGrid(21, 21, std::sqrt(Pi));
  std::vector<int> kept; // without every other triangle along the lower side
  for (int f = 0; f < grid.faceCount(); ++f)
  {
    const Eigen::Vector3d heights = grid.Vertices.col(1)(grid.Faces.row(f));
    const double lowest = grid.Vertices.col(1).minCoeff();
    const bool isAtSide = (heights.array() < lowest + 1e-9).count() == 2;
    if (!isAtSide || f % 4 == 0)
    {
      kept.push_back(f);
    }
  }
  for (const TriangleMesh& mesh : { square, grid, extractFaces(grid, kept).Mesh })
  {
    ASSERT_FALSE(earsOf(mesh).empty());
    for (const double length : { 0.03, 0.06, 0.15 })
    {
      for (const int iterations : { 0, 3 })
      {
        const TriangleMesh result = remeshIsotropically(mesh, length, iterations).Mesh;
        EXPECT_TRUE(earsOf(result).empty()) << mesh.faceCount() << ", " << length << ", " << iterations;
        EXPECT_NEAR(faceAreas(result.Vertices, result.Faces).sum(),
          faceAreas(mesh.Vertices, mesh.Faces).sum(),
          1e-12);
        requireDisk(result);
      }
    }
  }
}

TEST(IsotropicRemeshing, KeepsHandles)
{
  const DerivedMesh remeshed = remeshIsotropically(torus(60, 20), 0.2);
  const MeshTopology topology = analyseTopology(remeshed.Mesh.Faces, remeshed.Mesh.vertexCount());
  EXPECT_EQ(topology.eulerCharacteristic(), 0);
  EXPECT_GT(smallestAngle(remeshed.Mesh), 15.0);
}

TEST(IsotropicRemeshing, TheResultDoesNotDependOnThreadsAndScale)
{
  const TriangleMesh input = sphereWithSlivers();
  const double length = meanEdgeLength(input);
  const DerivedMesh many = remeshIsotropically(input, length);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const DerivedMesh single = remeshIsotropically(input, length);
  EXPECT_EQ(single.Mesh.Faces, many.Mesh.Faces);
  EXPECT_EQ(single.Mesh.Vertices, many.Mesh.Vertices);
  EXPECT_EQ(single.Faces, many.Faces);
  for (const double scale : { std::ldexp(1.0, -30), std::ldexp(1.0, 30) }) // exact in binary
  {
    TriangleMesh scaled = input;
    scaled.Vertices *= scale;
    const DerivedMesh other = remeshIsotropically(scaled, scale * length);
    EXPECT_EQ(other.Mesh.Faces, many.Mesh.Faces) << scale;
    EXPECT_EQ(other.Mesh.Vertices, Points3(scale * many.Mesh.Vertices)) << scale;
  }
}

// Two spheres are so close that chords of one intersect the other.
TEST(IsotropicRemeshing, SheetsThatNearlyTouchStayApart)
{
  TriangleMesh outer = sphere(5);
  TriangleMesh inner = sphere(4);
  inner.Vertices *= 0.997;
  inner.Faces.col(1).swap(inner.Faces.col(2));
  const TriangleMesh input = both(outer, inner);
  ASSERT_EQ(countSelfIntersections(input), 0u);
  const DerivedMesh remeshed = remeshIsotropically(input, 0.12);
  EXPECT_EQ(countSelfIntersections(remeshed.Mesh), 0u);
  EXPECT_GT(smallestAngle(remeshed.Mesh), 5.0);
}

TEST(SelfIntersections, CountsPairs)
{
  EXPECT_EQ(countSelfIntersections(sphere(3)), 0u);
  const TriangleMesh crossed = both(tetrahedron(), moved(tetrahedron(), 0.2, 0.2, 0.2));
  // Only the slanted face of the first one meets the second one.
  EXPECT_EQ(countSelfIntersections(crossed), 3u);
  EXPECT_EQ(
    intersectionsPerGroup(crossed, { { 0 }, { 1 }, { 2 }, { 3 } }), (std::vector<int>{ 0, 0, 0, 3 }));
  // Two faces folded onto each other over their common edge.
  const TriangleMesh folded =
    meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 1, 0 }, { 0.5, 0.4, 0 } }, { { 0, 1, 2 }, { 1, 0, 3 } });
  EXPECT_EQ(countSelfIntersections(folded), 1u);
}

TEST(ClosestPointWalk, FindsWhatTheSearchOfTheWholeFinds)
{
  const TriangleMesh mesh = sphere(4);
  const ClosestPointTree projection(mesh);
  const ClosestPointWalk walk(mesh);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1.2, 1.2);
  for (int i = 0; i < 200; ++i)
  {
    const Eigen::Vector3d point(coordinate(random), coordinate(random), coordinate(random));
    const double expected = (projection.closest(point).Position - point).norm();
    const SurfacePoint found =
      walk.closest(point, projection.closest(point * 0.5 + Eigen::Vector3d(0.1, 0.2, 0.05)).Face);
    EXPECT_NEAR((found.Position - point).norm(), expected, 1e-3);
    EXPECT_NEAR(found.Weights[0] + found.Weights[1] + found.Weights[2], 1.0, 1e-12);
  }
}

TEST(IsotropicRemeshing, CanBeCancelledAndNamesABadLength)
{
  const TriangleMesh input = sphere(3);
  EXPECT_THROW(
    remeshIsotropically(input, 0.1, 3, [](double fraction, const char*) { return fraction < 0.4; }),
    Cancelled);
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { remeshIsotropically(input, -1.0); }), "positive"));
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { remeshIsotropically(input, 10.0); }), "set it below"));
  for (const double tiny : { 1e-300, 1e-5 })
  {
    const std::string message = messageOf<InvalidInput>([&] { remeshIsotropically(input, tiny); });
    EXPECT_TRUE(contains(message, "points, more than 2e+07: set it above 0.0008")) << message;
  }
  // Every halving of a long thin triangle makes two long edges more. The area lets one expect few
  // points.
  const std::string message =
    messageOf<InvalidInput>([] { remeshIsotropically(cylinder(3000, 2, 200.0), 0.1); });
  EXPECT_TRUE(contains(message, "as the surface has long thin triangles")) << message;
}

} // namespace
