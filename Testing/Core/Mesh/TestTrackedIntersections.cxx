// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TrackedIntersections.h"
#include "Support/SampleSurfaces.h"

#include <random>

namespace
{

using namespace flattening;
using namespace flattening::samples;

TriangleMesh withoutFaces(const TriangleMesh& mesh, int first, int count)
{
  TriangleMesh rest = mesh;
  rest.Faces.resize(mesh.faceCount() - count, 3);
  rest.Faces << mesh.Faces.topRows(first), mesh.Faces.bottomRows(mesh.faceCount() - first - count);
  return rest;
}

// The pairs of a search among all faces.
TrackedIntersections::Pairs pairsOf(const TriangleMesh& mesh)
{
  return fewSelfIntersections(mesh, 1000000).Pairs;
}

void expectPairsOf(const TriangleMesh& mesh, TrackedIntersections& tracked)
{
  tracked.update(mesh);
  EXPECT_EQ(tracked.count(), countSelfIntersections(mesh));
  ASSERT_TRUE(tracked.pairs());
  EXPECT_EQ(*tracked.pairs(), pairsOf(mesh));
}

// Two spheres that intersect, and a vertex here and there that moves, through other faces too.
TEST(TrackedIntersections, AreThoseOfASearchAmongAllFaces)
{
  TriangleMesh mesh = both(sphere(4), moved(sphere(4), 1.7, 0.0, 0.0));
  TrackedIntersections tracked;
  expectPairsOf(mesh, tracked);
  ASSERT_GT(tracked.count(), 0u);
  std::mt19937 random(1);
  bool differed = false;
  for (int step = 0; step < 20; ++step)
  {
    const std::size_t before = tracked.count();
    mesh.Vertices.row(static_cast<int>(random() % mesh.vertexCount())) *= step % 2 == 0 ? 0.4 : 2.5;
    expectPairsOf(mesh, tracked);
    differed |= tracked.count() != before;
  }
  EXPECT_TRUE(differed);
}

TEST(TrackedIntersections, FollowFacesThatGetOtherNumbersAndCorners)
{
  const TriangleMesh mesh = both(sphere(4), moved(sphere(4), 1.7, 0.0, 0.0));
  TrackedIntersections tracked;
  expectPairsOf(mesh, tracked);
  TriangleMesh other = withoutFaces(mesh, 100, 50);
  other.Vertices = mesh.Vertices.colwise().reverse().eval();
  other.Faces = (mesh.vertexCount() - 1 - other.Faces.array()).matrix();
  for (int f = 0; f < other.faceCount(); f += 2)
  {
    const Eigen::RowVector3i face = other.Faces.row(f);
    other.Faces.row(f) << face[1], face[2], face[0];
  }
  expectPairsOf(other, tracked);
  expectPairsOf(mesh, tracked);
}

// Faces that touch without a common corner intersect, those that share it do not.
TEST(TrackedIntersections, KnowWhichCornersAreShared)
{
  const TriangleMesh joined = sphere(3);
  TriangleMesh apart = joined; // one face has corners of its own on the same points
  apart.Vertices.conservativeResize(joined.vertexCount() + 3, 3);
  for (int k = 0; k < 3; ++k)
  {
    apart.Vertices.row(joined.vertexCount() + k) = joined.Vertices.row(joined.Faces(7, k));
    apart.Faces(7, k) = joined.vertexCount() + k;
  }
  TrackedIntersections tracked;
  expectPairsOf(joined, tracked);
  EXPECT_EQ(tracked.count(), 0u);
  expectPairsOf(apart, tracked);
  EXPECT_GE(tracked.count(), 12u);
  expectPairsOf(joined, tracked);
  EXPECT_EQ(tracked.count(), 0u);
}

// Copies of a face are faces of their own.
TEST(TrackedIntersections, CountEachOfSeveralFacesOnTheSamePoints)
{
  TriangleMesh mesh = sphere(3);
  TrackedIntersections tracked;
  expectPairsOf(mesh, tracked);
  const int faces = mesh.faceCount();
  mesh.Faces.conservativeResize(faces + 2, 3);
  mesh.Faces.row(faces) = mesh.Faces.row(5);
  mesh.Faces.row(faces + 1) = mesh.Faces.row(5);
  expectPairsOf(mesh, tracked);
  EXPECT_GE(tracked.count(), 3u);
}

TEST(TrackedIntersections, KeepNoMorePairsThanFacesAndGoOn)
{
  TriangleMesh mesh = sphere(1);
  for (int copies = 0; copies < 3; ++copies)
  {
    mesh = both(mesh, mesh);
  }
  TrackedIntersections tracked;
  tracked.update(mesh);
  EXPECT_FALSE(tracked.pairs());
  EXPECT_EQ(tracked.count(), countSelfIntersections(mesh));
  EXPECT_GT(tracked.count(), static_cast<std::size_t>(mesh.faceCount()));
  expectPairsOf(sphere(1), tracked);
}

TEST(TrackedIntersections, OfTheNextMeshAreRightAfterAnAbort)
{
  const TriangleMesh mesh = both(sphere(3), moved(sphere(3), 1.7, 0.0, 0.0));
  TrackedIntersections tracked;
  expectPairsOf(mesh, tracked);
  TriangleMesh changed = mesh;
  changed.Vertices.row(3) *= 0.5;
  EXPECT_THROW(tracked.update(changed, [](double, const char*) { return false; }), Cancelled);
  expectPairsOf(changed, tracked);
}

} // namespace
