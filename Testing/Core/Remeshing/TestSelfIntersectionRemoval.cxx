// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshMeasures.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/IntersectionQueries.h"
#include "Remeshing/SelfIntersectionRemoval.h"
#include "Remeshing/SliverRemoval.h"
#include "Support/RandomNumbers.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

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
  ASSERT_EQ(countSelfIntersections(foldedSheet(1.5)), 0u);
  const TriangleMesh mesh = foldedSheet(2.6);
  ASSERT_GT(countSelfIntersections(mesh), 10u);
  MeshOnSurface surface(mesh);
  EXPECT_EQ(removeSelfIntersections(surface), 0);
  const TriangleMesh result = surface.derived().Mesh;
  EXPECT_EQ(countSelfIntersections(result), 0u);
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

// A pair is soon done, but there may be many.
TEST(SelfIntersectionRemoval, ReportsForEachPair)
{
  const TriangleMesh mesh = foldedSheet(4.0);
  const auto pairs = static_cast<int>(countSelfIntersections(mesh));
  std::map<std::string, int> reports;
  double last = 0.0;
  const auto count = [&](double fraction, const char* stage)
  {
    EXPECT_GE(fraction, last);
    last = fraction;
    ++reports[stage];
    return true;
  };
  MeshOnSurface surface(mesh);
  removeSelfIntersections(surface, count);
  EXPECT_GE(reports["removing self-intersections"], pairs);
  EXPECT_GE(reports["smoothing where faces intersect"], pairs / 2);
}

TEST(SelfIntersectionRemoval, StopsAtAPairWhenTold)
{
  const TriangleMesh mesh = foldedSheet(4.0);
  MeshOnSurface surface(mesh);
  const auto stop = [](double, const char* stage)
  { return std::string(stage) != "smoothing where faces intersect"; };
  EXPECT_THROW(removeSelfIntersections(surface, stop), Cancelled);
}

TEST(SelfIntersectionRemoval, LeavesSheetsThatOnlyComeNear)
{
  const TriangleMesh mesh = foldedSheet(1.9);
  ASSERT_EQ(countSelfIntersections(mesh), 0u);
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

/// Strips of two triangles side by side, each a thousand times as long as wide and along the diagonal of
/// x and y, so that the boxes of all faces overlap. Every so many strips an end lies beyond the next.
TriangleMesh diagonalStrips(int strips, int everySoMany)
{
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i <= strips; ++i)
  {
    const double x = static_cast<double>(i) / strips;
    const double end = x + (i % everySoMany == 1 ? 1.5 / strips : 0.0);
    vertices.push_back({ x, 0.0, 0.0 });
    vertices.push_back({ end + 1000.0, 1000.0, 0.0 });
  }
  for (int i = 0; i < strips; ++i)
  {
    faces.push_back({ 2 * i, 2 * i + 2, 2 * i + 3 });
    faces.push_back({ 2 * i, 2 * i + 3, 2 * i + 1 });
  }
  return meshOf(vertices, faces);
}

// Where all faces are near all pairs, work on them would grow with the square of the faces.
TEST(SelfIntersectionRemoval, LeavesPairsThatAreNearTooManyFaces)
{
  const TriangleMesh mesh = diagonalStrips(2000, 50);
  MeshOnSurface surface(mesh);
  TrackedIntersections known;
  const FacePairs pairs = intersectingFaces(surface, known).value();
  ASSERT_LT(pairs.size(), 400u) << "few enough for changes";
  ASSERT_GT(pairs.size(), 250u) << "each near 4000 faces, more than a million together";
  std::vector<std::vector<MeshOnSurface::Vertex>> groups;
  for (const FacePair& pair : pairs)
  {
    groups.push_back(verticesAround(surface, pair, 1));
  }
  EXPECT_FALSE(facesNear(surface, groups).has_value());
  groups.resize(250); // a million entries
  const auto near = facesNear(surface, groups);
  ASSERT_TRUE(near.has_value());
  EXPECT_EQ(near->front().size(), 4000u);
  EXPECT_EQ(removeSelfIntersections(surface), static_cast<int>(pairs.size()));
  EXPECT_EQ(surface.derived().Mesh.Vertices, mesh.Vertices);
}

// Work on a single pair would grow with the square of the faces near it. A ball between the sheet and
// the bump is near all pairs.
TEST(SelfIntersectionRemoval, LeavesPairsThatAreEachNearTooManyFaces)
{
  for (const int levels : { 2, 5 })
  {
    TriangleMesh ball = sphere(levels);
    ball.Vertices *= 0.02;
    const bool hasTooMany = ball.faceCount() > static_cast<int>(MostNearOnePair);
    EXPECT_EQ(hasTooMany, levels == 5);
    const TriangleMesh mesh = both(foldedSheet(2.6), moved(ball, 6.0, 6.0, 2.3));
    const auto pairs = static_cast<int>(countSelfIntersections(mesh));
    EXPECT_EQ(pairs, static_cast<int>(countSelfIntersections(foldedSheet(2.6))));
    MeshOnSurface surface(mesh);
    const int left = removeSelfIntersections(surface);
    EXPECT_EQ(left == pairs, hasTooMany);
    EXPECT_EQ(surface.derived().Mesh.Vertices == mesh.Vertices, hasTooMany);
  }
}

// The limit on overlapping boxes is exact.
TEST(SelfIntersectionRemoval, CountsOverlappingBoxesUpToALimit)
{
  const TriangleMesh mesh = diagonalStrips(20, 50);
  std::vector<Eigen::AlignedBox3d> boxes(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      boxes[f].extend(mesh.Vertices.row(mesh.Faces(f, k)).transpose());
    }
  }
  std::size_t overlapping = 0;
  for (const Eigen::AlignedBox3d& a : boxes)
  {
    for (const Eigen::AlignedBox3d& b : boxes)
    {
      overlapping += a.intersects(b);
    }
  }
  ASSERT_EQ(overlapping, 1600u);
  const auto pairs = [&](std::size_t most)
  {
    return fewOverlappingBoxes(
      boxes, mesh.faceCount(), [&](int f) { return boxes[f]; }, most);
  };
  EXPECT_EQ(pairs(overlapping).value().size(), overlapping);
  EXPECT_FALSE(pairs(overlapping - 1).has_value());
}

} // namespace
