// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/MeshOnSurface.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

bool always(const LocalChange&)
{
  return true;
}

TriangleMesh flatHexagon()
{
  TriangleMesh hexagon = meshOf({ { 0, 0, 0 } }, {});
  hexagon.Vertices.conservativeResize(7, 3);
  hexagon.Faces.resize(6, 3);
  for (int k = 0; k < 6; ++k)
  {
    hexagon.Vertices.row(1 + k) << std::cos(Pi / 3 * k), std::sin(Pi / 3 * k), 0.0;
    hexagon.Faces.row(k) << 0, 1 + k, 1 + (k + 1) % 6;
  }
  return hexagon;
}

/// Lifts the centre of a flat hexagon off the plane, splits a spoke and returns its new middle.
Eigen::Vector3d middleOfSpoke(double height)
{
  const TriangleMesh hexagon = flatHexagon();
  MeshOnSurface surface(hexagon);
  const MeshOnSurface::Vertex centre(0);
  EXPECT_TRUE(surface.move(centre, surface.place(centre), Eigen::Vector3d(0, 0, height), always));
  const MeshOnSurface::Halfedge spoke = surface.mesh().halfedge(centre, MeshOnSurface::Vertex(1));
  return surface.mesh().point(surface.split(surface.mesh().edge(spoke), always));
}

TEST(MeshOnSurface, MiddlesOfSplitEdgesGoToTheOldSurfaceWhereThatIsNear)
{
  EXPECT_LT((middleOfSpoke(0.1) - Eigen::Vector3d(0.5, 0.0, 0.0)).norm(), 1e-15);
}

// On the old surface the middle would be nearly as far from the lifted vertex as the other end of the
// edge: splitting long edges would not end.
TEST(MeshOnSurface, MiddlesOfSplitEdgesStayWhereTheOldSurfaceIsFar)
{
  EXPECT_LT((middleOfSpoke(10.0) - Eigen::Vector3d(0.5, 0.0, 5.0)).norm(), 1e-15);
}

// It takes the attributes of the vertex that is nearest to it all the same.
TEST(MeshOnSurface, AMovedVertexIsNotTheOldOneAnyMore)
{
  const TriangleMesh hexagon = flatHexagon();
  MeshOnSurface surface(hexagon);
  const MeshOnSurface::Vertex centre(0);
  ASSERT_TRUE(surface.move(centre, surface.place(centre), Eigen::Vector3d(0, 0, 0.1), always));
  const DerivedMesh derived = surface.derived();
  EXPECT_GT(derived.Vertices.innerVector(0).nonZeros(), 1);
  EXPECT_EQ(derived.Vertices.coeff(0, 0), 1.0);
  for (int v = 1; v < 7; ++v)
  {
    EXPECT_EQ(derived.Vertices.innerVector(v).nonZeros(), 1);
  }
}

// Where the surface is folded, a walk from a corner to the centroid of a face would end on another face,
// which lies opposite to it.
TEST(MeshOnSurface, FacesThatStayAreTheirOwnOrigins)
{
  const TriangleMesh fold =
    meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, 1, 0.2 } }, { { 0, 1, 2 }, { 1, 0, 3 } });
  EXPECT_EQ(MeshOnSurface(fold).derived().Faces, (std::vector<int>{ 0, 1 }));
}

// A hexagon of which some vertices are kept.
struct KeptHexagon
{
  explicit KeptHexagon(const std::vector<int>& keptVertices)
    : Old(std::make_shared<TriangleMesh>(flatHexagon()))
    , Walk(std::make_shared<ClosestPointWalk>(*this->Old))
    , Surface(this->Walk, placedOnItself(*this->Walk), flags(keptVertices))
  {
  }

  static std::vector<char> flags(const std::vector<int>& vertices)
  {
    std::vector<char> kept(7, 0);
    for (const int v : vertices)
    {
      kept[v] = 1;
    }
    return kept;
  }

  MeshOnSurface::Edge edge(int a, int b) const
  {
    const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
    return mesh.edge(mesh.halfedge(MeshOnSurface::Vertex(a), MeshOnSurface::Vertex(b)));
  }

  std::shared_ptr<TriangleMesh> Old;
  std::shared_ptr<ClosestPointWalk> Walk;
  MeshOnSurface Surface;
};

TEST(MeshOnSurface, NoEdgeBetweenKeptVerticesIsChangedOrMade)
{
  KeptHexagon spoke({ 0, 1 });
  EXPECT_FALSE(spoke.Surface.split(spoke.edge(0, 1), always).is_valid());
  EXPECT_FALSE(spoke.Surface.flip(spoke.edge(0, 1), always));
  EXPECT_FALSE(spoke.Surface.collapse(spoke.edge(0, 1), always));
  EXPECT_FALSE(spoke.Surface.move(
    MeshOnSurface::Vertex(0), spoke.Surface.place(MeshOnSurface::Vertex(1)), { 0, 0, 1 }, always));

  EXPECT_FALSE(KeptHexagon({ 1, 3 }).Surface.flip(KeptHexagon({}).edge(0, 2), always));
  EXPECT_TRUE(KeptHexagon({ 1 }).Surface.flip(KeptHexagon({}).edge(0, 2), always));

  // Without its centre, the hexagon would have edges from vertex 1 to the three vertices that are not
  // next to it.
  EXPECT_FALSE(KeptHexagon({ 1, 4 }).Surface.collapse(KeptHexagon({}).edge(0, 1), always));
  EXPECT_TRUE(KeptHexagon({ 1, 2 }).Surface.collapse(KeptHexagon({}).edge(0, 1), always));
}

TEST(MeshOnSurface, AKeptVertexKeepsItsNumberAndPlace)
{
  for (const bool reversed : { false, true })
  {
    KeptHexagon hexagon({ 1 });
    const MeshOnSurface::Mesh& mesh = hexagon.Surface.mesh();
    const MeshOnSurface::Vertex kept(1);
    const Eigen::Vector3d position = mesh.point(kept);
    const MeshOnSurface::Halfedge h = mesh.halfedge(hexagon.edge(0, 1));
    ASSERT_TRUE(hexagon.Surface.collapse(mesh.edge(reversed ? mesh.opposite(h) : h), always));
    EXPECT_FALSE(mesh.is_removed(kept));
    EXPECT_TRUE(mesh.is_removed(MeshOnSurface::Vertex(0)));
    EXPECT_EQ(mesh.point(kept), position);
  }
}

} // namespace
