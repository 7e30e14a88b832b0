// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HalfedgeSurface.h"
#include "Handles/HomologyLabels.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <array>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

TEST(HalfedgeSurface, CutsAndCapsALoop)
{
  const TriangleMesh mesh = torus(12, 8);
  HalfedgeSurface surface(mesh);
  // Around the tube: vertices 0 .. 7.
  std::vector<int> loop;
  for (int j = 0; j < 8; ++j)
  {
    loop.push_back(surface.edgeBetween(j, (j + 1) % 8));
    ASSERT_EQ(surface.source(loop.back()), j);
  }
  const int copies = surface.cut(loop);
  EXPECT_EQ(copies, 96);
  MeshTopology topology = analyseTopology(surface.mesh().Faces, surface.vertexCount());
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Genus, 0);
  ASSERT_EQ(topology.BoundaryLoops.size(), 2u);
  EXPECT_EQ(surface.boundaryLoops(), topology.BoundaryLoops);

  const int right = surface.addVertex({ 2.0, 0.0, 0.0 });
  const int left = surface.addVertex({ 2.0, 0.0, 0.0 });
  std::vector<std::array<int, 3>> caps;
  for (int j = 0; j < 8; ++j)
  {
    caps.push_back({ j, (j + 1) % 8, right });
    caps.push_back({ copies + (j + 1) % 8, copies + j, left });
  }
  surface.addFaces(caps);
  topology = analyseTopology(surface.mesh().Faces, surface.vertexCount());
  EXPECT_EQ(topology.eulerCharacteristic(), 2);
  EXPECT_TRUE(topology.BoundaryLoops.empty());
  for (int h = 0; h < surface.halfedgeCount(); ++h)
  {
    ASSERT_EQ(surface.twin(surface.twin(h)), h);
    ASSERT_EQ(surface.source(surface.twin(h)), surface.target(h));
    ASSERT_EQ(surface.source(surface.outgoing(surface.source(h))), surface.source(h));
  }
}

TEST(HalfedgeSurface, SplitsEveryInnerEdge)
{
  const TriangleMesh mesh = withoutFaces(torus(4, 3), { 0, 3, 12, 15 });
  HalfedgeSurface surface(mesh);
  HomologyLabels labels(surface);
  const int halfedges = surface.halfedgeCount();
  int splits = 0;
  for (int h = 0; h < halfedges; ++h)
  {
    if (h < surface.twin(h))
    {
      EXPECT_EQ(surface.splitEdge(h), mesh.vertexCount() + splits++);
      labels.followSplit(surface, h);
    }
  }
  const TriangleMesh split = surface.mesh();
  EXPECT_NEAR(totalArea(split), totalArea(mesh), 1e-14 * totalArea(mesh));
  EXPECT_EQ(analyseTopology(split.Faces, split.vertexCount()).BoundaryLoops,
    analyseTopology(mesh.Faces, mesh.vertexCount()).BoundaryLoops);
  for (int v = 0; v < surface.vertexCount(); ++v)
  {
    EXPECT_EQ(surface.source(surface.outgoing(v)), v);
    EXPECT_EQ(surface.onBoundary(v), v < mesh.vertexCount());
  }
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    EXPECT_EQ(labels.hash(3 * f) ^ labels.hash(3 * f + 1) ^ labels.hash(3 * f + 2), 0u);
  }
}

} // namespace
