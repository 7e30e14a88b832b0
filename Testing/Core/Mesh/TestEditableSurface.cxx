// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshTopology.h"
#include "Support/RandomSurfaces.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <numeric>
#include <random>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// CGAL's own way: one face after the other.
SurfaceMesh withFacesAdded(const TriangleMesh& mesh)
{
  using Vertex = SurfaceMesh::Vertex_index;
  SurfaceMesh surface;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    surface.add_vertex(pointOf(mesh.Vertices, v));
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const auto corners = mesh.Faces.row(f);
    EXPECT_NE(surface.add_face(Vertex(corners[0]), Vertex(corners[1]), Vertex(corners[2])),
      SurfaceMesh::null_face());
  }
  return surface;
}

void expectSame(const SurfaceMesh& a, const SurfaceMesh& b)
{
  ASSERT_EQ(a.num_vertices(), b.num_vertices());
  ASSERT_EQ(a.num_halfedges(), b.num_halfedges());
  ASSERT_EQ(a.num_faces(), b.num_faces());
  for (const auto v : a.vertices())
  {
    EXPECT_EQ(a.halfedge(v), b.halfedge(v)) << v;
  }
  for (const auto h : a.halfedges())
  {
    EXPECT_EQ(a.target(h), b.target(h)) << h;
    EXPECT_EQ(a.face(h), b.face(h)) << h;
    EXPECT_EQ(a.next(h), b.next(h)) << h;
    EXPECT_EQ(a.prev(h), b.prev(h)) << h;
  }
  for (const auto f : a.faces())
  {
    EXPECT_EQ(a.halfedge(f), b.halfedge(f)) << f;
  }
}

TriangleMesh shuffled(TriangleMesh mesh)
{
  std::vector<int> order(mesh.faceCount());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  const FaceMatrix faces = mesh.Faces;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    mesh.Faces.row(f) = faces.row(order[f]);
  }
  return mesh;
}

// The half-edges with which the walks around vertices begin are the same, too, so that sums along these
// walks have the same bits.
TEST(SurfaceMesh, IsTheOneThatAddingFacesMakes)
{
  int open = 0;
  int closed = 0;
  for (int seed = 1; seed <= 60; ++seed)
  {
    const TriangleMesh mesh = randomSurface(seed).Mesh;
    try
    {
      const MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
      ++(topology.BoundaryLoops.empty() ? closed : open);
    }
    catch (const std::exception&)
    {
      continue;
    }
    SCOPED_TRACE(seed);
    expectSame(toSurfaceMesh(mesh), withFacesAdded(mesh));
    const TriangleMesh other = shuffled(mesh);
    expectSame(toSurfaceMesh(other), withFacesAdded(other));
  }
  EXPECT_GE(open, 5);
  EXPECT_GE(closed, 3);
}

TEST(SurfaceMesh, KeepsVerticesWithoutFaces)
{
  TriangleMesh mesh = tetrahedron();
  mesh.Vertices.conservativeResize(6, 3);
  mesh.Vertices.bottomRows<2>().setOnes();
  const SurfaceMesh surface = toSurfaceMesh(mesh);
  EXPECT_EQ(surface.num_vertices(), 6u);
  EXPECT_EQ(surface.point(SurfaceMesh::Vertex_index(3)), pointOf(mesh.Vertices, 3));
  EXPECT_TRUE(surface.is_isolated(SurfaceMesh::Vertex_index(5)));
}

TEST(SurfaceMesh, HasPartsWithABoundaryThatMeetAtAVertex)
{
  const TriangleMesh mesh = meshOf(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } }, { { 0, 1, 2 }, { 0, 3, 4 } });
  const SurfaceMesh surface = toSurfaceMesh(mesh);
  expectSame(surface, withFacesAdded(mesh));
  EXPECT_TRUE(surface.is_valid(false));
  EXPECT_EQ(surface.degree(SurfaceMesh::Vertex_index(0)), 4u);
}

TEST(SurfaceMesh, RefusesWhatIsNoOrientedManifold)
{
  const auto refuses = [](const std::vector<std::array<int, 3>>& faces)
  {
    const TriangleMesh mesh =
      meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } }, faces);
    EXPECT_THROW(toSurfaceMesh(mesh), TopologyError);
  };
  refuses({ { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } });              // three faces at an edge
  refuses({ { 0, 1, 2 }, { 0, 1, 3 } });                           // two faces against each other
  refuses({ { 0, 1, 2 }, { 0, 2, 1 }, { 0, 3, 4 }, { 0, 4, 3 } }); // closed parts that meet at a vertex
  refuses({ { 0, 0, 1 }, { 1, 0, 2 } });                           // a face with a vertex twice
  refuses({ { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 }, { 4, 3, 0 }, { 4, 0, 1 } }); // a Moebius strip
}

} // namespace
