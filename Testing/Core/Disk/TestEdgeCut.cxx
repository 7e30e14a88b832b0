// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Disk/EdgeCut.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <numeric>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// Expects every corner to stay where it was, and every copy to be made of its original alone.
void expectNothingMoved(const TriangleMesh& mesh, const CutSurface& cut)
{
  const DerivedMesh& surface = cut.Surface;
  ASSERT_EQ(surface.Mesh.faceCount(), mesh.faceCount());
  ASSERT_EQ(cut.OnSeam.size(), std::size_t(surface.Mesh.vertexCount()));
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    EXPECT_EQ(surface.Faces[f], f);
    for (int k = 0; k < 3; ++k)
    {
      const int v = surface.Mesh.Faces(f, k);
      EXPECT_EQ(surface.Mesh.Vertices.row(v), mesh.Vertices.row(mesh.Faces(f, k)));
      EXPECT_EQ(surface.Vertices.coeff(v, mesh.Faces(f, k)), 1.0);
    }
  }
  EXPECT_EQ(surface.Vertices.nonZeros(), surface.Mesh.vertexCount());
}

// Vertices j of column i of a torus, closed.
std::vector<MeshEdge> meridian(int i, int m)
{
  std::vector<MeshEdge> edges;
  for (int j = 0; j < m; ++j)
  {
    edges.push_back({ i * m + j, i * m + (j + 1) % m });
  }
  return edges;
}

std::vector<MeshEdge> longitude(int j, int n, int m)
{
  std::vector<MeshEdge> edges;
  for (int i = 0; i < n; ++i)
  {
    edges.push_back({ i * m + j, (i + 1) % n * m + j });
  }
  return edges;
}

TEST(EdgeCut, OpensATorusIntoATubeAndATubeIntoADisk)
{
  constexpr int n = 30;
  constexpr int m = 12;
  const TriangleMesh mesh = torus(n, m);
  std::vector<MeshEdge> seam = meridian(3, m);
  const CutSurface tube = cutAlongEdges(mesh, seam);
  expectNothingMoved(mesh, tube);
  const MeshTopology topology = analyseTopology(tube.Surface.Mesh.Faces, n * m + m);
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_EQ(topology.BoundaryLoops.size(), 2u);
  EXPECT_EQ(tube.Surface.Mesh.vertexCount(), n * m + m);

  const std::vector<MeshEdge> around = longitude(5, n, m);
  seam.insert(seam.end(), around.begin(), around.end());
  const CutSurface disk = cutAlongEdges(mesh, seam);
  expectNothingMoved(mesh, disk);
  EXPECT_EQ(requireDisk(disk.Surface.Mesh).size(), 2u * (n + m));
  // Where the two cross there are four sectors, elsewhere two.
  EXPECT_EQ(disk.Surface.Mesh.vertexCount(), n * m + (n - 1) + (m - 1) + 3);
  EXPECT_EQ(std::accumulate(disk.OnSeam.begin(), disk.OnSeam.end(), 0), 2 * (n + m));
}

TEST(EdgeCut, AnOpenSeamLeavesItsEndsWhole)
{
  const TriangleMesh mesh = sphere(3);
  const int a = mesh.Faces(100, 0);
  const int b = mesh.Faces(100, 1);
  // A seam of one edge, whichever way it is named and however often, opens nothing.
  const CutSurface slit = cutAlongEdges(mesh, { { a, b }, { b, a } });
  expectNothingMoved(mesh, slit);
  EXPECT_EQ(slit.Surface.Mesh.vertexCount(), mesh.vertexCount());
  EXPECT_EQ(slit.OnSeam[a] + slit.OnSeam[b], 2);
  // One of two edges doubles the vertex between them.
  const int c = mesh.Faces(100, 2);
  const CutSurface slot = cutAlongEdges(mesh, { { a, b }, { b, c } });
  expectNothingMoved(mesh, slot);
  EXPECT_EQ(slot.Surface.Mesh.vertexCount(), mesh.vertexCount() + 1);
  EXPECT_EQ(requireDisk(slot.Surface.Mesh).size(), 4u);
}

TEST(EdgeCut, AlongTheBoundaryChangesNothing)
{
  const TriangleMesh tube = cylinder(8, 2, 1.0);
  const CutSurface rim = cutAlongEdges(tube, { { 0, 1 }, { 1, 2 } });
  EXPECT_EQ(rim.Surface.Mesh.Faces, tube.Faces);
  EXPECT_EQ(rim.Surface.Mesh.Vertices, tube.Vertices);
  // From one rim to the other: a disk.
  const CutSurface disk = cutAlongEdges(tube, { { 0, 8 }, { 8, 16 } });
  expectNothingMoved(tube, disk);
  EXPECT_EQ(requireDisk(disk.Surface.Mesh).size(), 8u + 8u + 4u);
}

TEST(EdgeCut, RejectsVerticesThatNoEdgeJoins)
{
  const TriangleMesh mesh = icosahedron();
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { cutAlongEdges(mesh, { { 0, 3 } }); }), "no edge"));
  EXPECT_TRUE(contains(messageOf<InvalidInput>(
                         [&] {
                           cutAlongEdges(mesh, { { 0, 12 } });
                         }),
    "names vertex 12"));
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { cutAlongEdges(mesh, { { 7, 7 } }); }), "no edge"));
}

} // namespace
