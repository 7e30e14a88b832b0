// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/MeshOnSurface.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

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

} // namespace
