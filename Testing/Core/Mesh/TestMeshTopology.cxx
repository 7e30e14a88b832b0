// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <limits>
#include <string>

namespace
{

using namespace flattening;

FaceMatrix facesOf(std::initializer_list<std::array<int, 3>> list)
{
  FaceMatrix faces(static_cast<Eigen::Index>(list.size()), 3);
  Eigen::Index f = 0;
  for (const auto& face : list)
  {
    faces.row(f++) << face[0], face[1], face[2];
  }
  return faces;
}

// A grid of n x m squares in the plane; with wrapped sides a cylinder or a torus (as connectivity).
FaceMatrix gridFaces(int n, int m, bool wrapFirst, bool wrapSecond)
{
  const int rows = wrapFirst ? n : n + 1;
  const int columns = wrapSecond ? m : m + 1;
  FaceMatrix faces(2 * n * m, 3);
  Eigen::Index f = 0;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      const auto vertex = [&](int a, int b) { return (a % rows) * columns + b % columns; };
      faces.row(f++) << vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1);
      faces.row(f++) << vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1);
    }
  }
  return faces;
}

TriangleMesh squareMesh(int n)
{
  TriangleMesh mesh;
  mesh.Faces = gridFaces(n, n, false, false);
  mesh.Vertices.resize((n + 1) * (n + 1), 3);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      mesh.Vertices.row(i * (n + 1) + j) << i, j, 0.5 * i * j;
    }
  }
  return mesh;
}

const FaceMatrix Octahedron = facesOf({ { 0, 1, 2 },
  { 0, 2, 3 },
  { 0, 3, 4 },
  { 0, 4, 1 },
  { 5, 2, 1 },
  { 5, 3, 2 },
  { 5, 4, 3 },
  { 5, 1, 4 } });

// Runs the body and returns the message of the exception of that type; fails without one.
template <typename Error, typename Body>
std::string messageOf(const Body& body)
{
  try
  {
    body();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  ADD_FAILURE() << "no exception of the expected type";
  return {};
}

void expectContains(const std::string& message, std::initializer_list<const char*> parts)
{
  for (const char* part : parts)
  {
    EXPECT_NE(message.find(part), std::string::npos) << "\"" << message << "\" lacks \"" << part << "\"";
  }
}

TEST(AnalyseTopology, Disk)
{
  const MeshTopology topology = analyseTopology(gridFaces(4, 3, false, false), 20);
  EXPECT_EQ(topology.Vertices, 20);
  EXPECT_EQ(topology.Edges, 4 * 4 + 5 * 3 + 12);
  EXPECT_EQ(topology.Faces, 24);
  EXPECT_EQ(topology.eulerCharacteristic(), 1);
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Genus, 0);
  ASSERT_EQ(topology.BoundaryLoops.size(), 1u);
  EXPECT_EQ(topology.BoundaryLoops[0].size(), 14u);
}

TEST(AnalyseTopology, BoundaryLoopRunsWithTheSurfaceOnItsLeft)
{
  const MeshTopology topology = analyseTopology(facesOf({ { 3, 1, 2 }, { 2, 1, 0 } }), 4);
  ASSERT_EQ(topology.BoundaryLoops.size(), 1u);
  EXPECT_EQ(topology.BoundaryLoops[0], (std::vector<int>{ 0, 2, 3, 1 }));
}

TEST(AnalyseTopology, Sphere)
{
  const MeshTopology topology = analyseTopology(Octahedron, 6);
  EXPECT_EQ(topology.eulerCharacteristic(), 2);
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_TRUE(topology.BoundaryLoops.empty());
}

TEST(AnalyseTopology, TorusHasGenusOne)
{
  const MeshTopology topology = analyseTopology(gridFaces(5, 4, true, true), 20);
  EXPECT_EQ(topology.eulerCharacteristic(), 0);
  EXPECT_EQ(topology.Genus, 1);
  EXPECT_TRUE(topology.BoundaryLoops.empty());
}

TEST(AnalyseTopology, CylinderHasTwoLoopsLongestFirst)
{
  FaceMatrix faces = gridFaces(2, 6, false, true);
  faces.conservativeResize(faces.rows() + 1, Eigen::NoChange);
  faces.row(faces.rows() - 1) << 0, 1, 18; // makes the loop of vertices 0..5 one longer
  const MeshTopology topology = analyseTopology(faces, 19);
  EXPECT_EQ(topology.Genus, 0);
  ASSERT_EQ(topology.BoundaryLoops.size(), 2u);
  EXPECT_EQ(topology.BoundaryLoops[0].size(), 7u);
  EXPECT_EQ(topology.BoundaryLoops[1].size(), 6u);
  EXPECT_EQ(topology.BoundaryLoops[0].front(), 0);
  EXPECT_EQ(topology.BoundaryLoops[1].front(), 12);
}

TEST(AnalyseTopology, GenusIsSummedOverComponents)
{
  const FaceMatrix torus = gridFaces(4, 4, true, true);
  FaceMatrix faces(2 * torus.rows() + Octahedron.rows(), 3);
  faces << torus, torus.array() + 16, Octahedron.array() + 32;
  const MeshTopology topology = analyseTopology(faces, 38);
  EXPECT_EQ(topology.Components, 3);
  EXPECT_EQ(topology.Genus, 2);
}

TEST(AnalyseTopology, UnusedVerticesAreNotCounted)
{
  const MeshTopology topology = analyseTopology(facesOf({ { 4, 7, 2 } }), 9);
  EXPECT_EQ(topology.Vertices, 3);
  EXPECT_EQ(topology.Components, 1);
}

TEST(AnalyseTopology, NonManifoldEdge)
{
  const FaceMatrix faces = facesOf({ { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } });
  expectContains(messageOf<TopologyError>([&] { analyseTopology(faces, 5); }),
    { "edge (0, 1)", "non-manifold", "3 faces", "Surface To Disk" });
}

TEST(AnalyseTopology, NonManifoldVertex)
{
  const FaceMatrix faces = facesOf({ { 0, 1, 2 }, { 2, 3, 4 } });
  expectContains(messageOf<TopologyError>([&] { analyseTopology(faces, 5); }),
    { "vertex 2", "non-manifold", "Surface To Disk" });
}

TEST(AnalyseTopology, Misorientation)
{
  const FaceMatrix faces = facesOf({ { 0, 1, 2 }, { 0, 1, 3 } });
  expectContains(messageOf<TopologyError>([&] { analyseTopology(faces, 4); }),
    { "faces 0 and 1", "edge (0, 1)", "oriented against each other", "Surface To Disk" });
}

TEST(AnalyseTopology, BadIndices)
{
  expectContains(messageOf<InvalidInput>(
                   [] {
                     analyseTopology(facesOf({ { 0, 1, 3 } }), 3);
                   }),
    { "face 0", "vertex 3", "3 vertices" });
  expectContains(messageOf<InvalidInput>(
                   [] {
                     analyseTopology(facesOf({ { 0, -1, 2 } }), 3);
                   }),
    { "face 0", "vertex -1" });
  expectContains(messageOf<InvalidInput>(
                   [] {
                     analyseTopology(facesOf({ { 0, 1, 2 }, { 1, 2, 1 } }), 3);
                   }),
    { "face 1", "vertex 1 twice", "Surface To Disk" });
}

TEST(RequireDisk, ReturnsTheBoundary)
{
  const std::vector<int> loop = requireDisk(squareMesh(3));
  EXPECT_EQ(loop.size(), 12u);
  EXPECT_EQ(loop.front(), 0);
}

TEST(RequireDisk, NoTriangles)
{
  TriangleMesh mesh = squareMesh(2);
  mesh.Faces.resize(0, 3);
  expectContains(messageOf<InvalidInput>([&] { requireDisk(mesh); }), { "no triangles", "Contour" });
}

TEST(RequireDisk, NotFinite)
{
  for (const double value :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    TriangleMesh mesh = squareMesh(2);
    mesh.Vertices(5, 1) = value;
    expectContains(messageOf<InvalidInput>([&] { requireDisk(mesh); }), { "vertex 5", "not finite" });
  }
}

TEST(RequireDisk, ZeroArea)
{
  TriangleMesh mesh = squareMesh(2);
  mesh.Vertices.rightCols<2>().setZero();
  expectContains(messageOf<InvalidInput>([&] { requireDisk(mesh); }), { "zero area", "degenerate" });
}

TEST(RequireDisk, UnusedVertex)
{
  TriangleMesh mesh = squareMesh(2);
  mesh.Vertices.conservativeResize(11, Eigen::NoChange);
  mesh.Vertices.bottomRows(2).setOnes();
  expectContains(messageOf<TopologyError>([&] { requireDisk(mesh); }), { "2 points", "no triangle" });
}

TriangleMesh withPositions(const FaceMatrix& faces)
{
  TriangleMesh mesh;
  mesh.Faces = faces;
  mesh.Vertices = Points3::Random(faces.maxCoeff() + 1, 3);
  return mesh;
}

TEST(RequireDisk, Closed)
{
  expectContains(messageOf<TopologyError>([] { requireDisk(withPositions(Octahedron)); }),
    { "closed", "boundary", "Surface To Disk" });
}

TEST(RequireDisk, Genus)
{
  FaceMatrix faces = gridFaces(5, 4, true, true);
  faces.conservativeResize(faces.rows() - 1, Eigen::NoChange);
  expectContains(messageOf<TopologyError>([&] { requireDisk(withPositions(faces)); }),
    { "genus 1", "Surface To Disk" });
}

TEST(RequireDisk, SeveralComponents)
{
  const FaceMatrix faces = facesOf({ { 0, 1, 2 }, { 3, 4, 5 } });
  expectContains(messageOf<TopologyError>([&] { requireDisk(withPositions(faces)); }),
    { "2 components", "Connectivity" });
}

TEST(RequireDisk, SeveralBoundaries)
{
  expectContains(
    messageOf<TopologyError>([] { requireDisk(withPositions(gridFaces(2, 6, false, true))); }),
    { "2 boundary loops", "Surface To Disk" });
}

} // namespace
