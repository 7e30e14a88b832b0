// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HandleLoops.h"
#include "Mesh/MeshTopology.h"
#include "Support/CubeSurfaces.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

/// Cuts along all edges of the loops at once, by joining the corners on the two sides of all others.
MeshTopology topologyOfCut(const TriangleMesh& mesh, const std::vector<std::vector<int>>& loops)
{
  std::set<std::pair<int, int>> cut;
  for (const auto& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const int a = loop[i];
      const int b = loop[(i + 1) % loop.size()];
      cut.insert(std::minmax(a, b));
    }
  }
  std::vector<int> parent(3 * mesh.faceCount());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int i)
  {
    while (parent[i] != i)
    {
      i = parent[i] = parent[parent[i]];
    }
    return i;
  };
  const auto next = [](int corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
  const auto vertex = [&mesh](int corner) { return mesh.Faces(corner / 3, corner % 3); };
  std::map<std::pair<int, int>, int> sides; // from, to: corner at from
  for (int c = 0; c < 3 * mesh.faceCount(); ++c)
  {
    sides[{ vertex(c), vertex(next(c)) }] = c;
  }
  std::size_t found = 0;
  for (const auto& [ends, corner] : sides)
  {
    const auto opposite = sides.find({ ends.second, ends.first });
    if (cut.count(std::minmax(ends.first, ends.second)))
    {
      ++found;
    }
    else if (opposite != sides.end())
    {
      parent[root(corner)] = root(next(opposite->second));
      parent[root(next(corner))] = root(opposite->second);
    }
  }
  EXPECT_EQ(found, 2 * cut.size()); // all are edges
  FaceMatrix faces(mesh.faceCount(), 3);
  for (int c = 0; c < 3 * mesh.faceCount(); ++c)
  {
    faces(c / 3, c % 3) = root(c);
  }
  return analyseTopology(faces, 3 * mesh.faceCount());
}

void expectPlanarAfterCut(const TriangleMesh& mesh, int handles)
{
  const HandleLoops result = handleLoops(mesh);
  ASSERT_EQ(result.Loops.size(), std::size_t(handles));
  const MeshTopology before = analyseTopology(mesh.Faces, mesh.vertexCount());
  const MeshTopology topology = topologyOfCut(result.Surface.Mesh, result.Loops);
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_EQ(topology.BoundaryLoops.size(), before.BoundaryLoops.size() + 2 * handles);
  EXPECT_NEAR(totalArea(result.Surface.Mesh), totalArea(mesh), 1e-12 * totalArea(mesh));
  EXPECT_EQ(result.Surface.Mesh.Vertices.topRows(mesh.vertexCount()), mesh.Vertices);
  EXPECT_LT(
    (result.Surface.Vertices * mesh.Vertices - result.Surface.Mesh.Vertices).cwiseAbs().maxCoeff(),
    1e-12);
}

TEST(HandleLoops, LeaveAPlanarSurface)
{
  expectPlanarAfterCut(torus(30, 12), 1);
  expectPlanarAfterCut(withoutFaces(torus(20, 10), { 0, 1, 100, 101, 102, 300 }), 1);
  for (int n = 1; n <= 8; ++n)
  {
    SCOPED_TRACE(n);
    expectPlanarAfterCut(slabWithTunnels(n, 3), n);
    expectPlanarAfterCut(blockWithHandles(n, 2), n);
  }
  EXPECT_EQ(handleLoops(slabWithTunnels(3, 3)).Surface.Mesh.Faces, slabWithTunnels(3, 3).Faces);
}

// These meshes have no room for loops that do not meet, so edges are split.
TEST(HandleLoops, SplitEdgesOfCoarseMeshes)
{
  for (int n = 1; n <= 8; ++n)
  {
    SCOPED_TRACE(n);
    expectPlanarAfterCut(slabWithTunnels(n), n);
    expectPlanarAfterCut(blockWithHandles(n), n);
  }
  expectPlanarAfterCut(torus(3, 3), 1);
  expectPlanarAfterCut(withoutFaces(torus(4, 3), { 0, 3, 12, 15 }), 1);
}

} // namespace
