// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/DijkstraDistance.h"
#include "Support/SampleSurfaces.h"

#include <set>

namespace
{

using namespace flattening;
using namespace flattening::samples;

using Vertex = SurfaceMesh::Vertex_index;

// The target is that of the least distance, and the distances up to it are those of the whole surface.
TEST(NearestTarget, IsThatOfTheLeastDistance)
{
  const SurfaceMesh mesh = toSurfaceMesh(sphere(4));
  const Vertex source(17);
  const Eigen::VectorXd distances = distancesAlongEdges(mesh, { source });
  const std::set<Vertex> targets{ Vertex(900), Vertex(1234), Vertex(2001) };
  Vertex expected = *targets.begin();
  for (const Vertex v : targets)
  {
    expected = distances[v] < distances[expected] ? v : expected;
  }
  const NearestTarget nearest =
    nearestTarget(mesh, source, [&targets](Vertex v) { return targets.count(v) > 0; }, {});
  EXPECT_EQ(nearest.Vertex, expected);
  int farther = 0;
  for (const Vertex v : mesh.vertices())
  {
    if (distances[v] <= distances[expected])
    {
      EXPECT_EQ(nearest.Distances[v], distances[v]);
    }
    else
    {
      EXPECT_GE(nearest.Distances[v], distances[v]);
      farther += std::isinf(nearest.Distances[v]);
    }
  }
  EXPECT_GT(farther, 0); // it looked no farther
  EXPECT_EQ(shortestPath(mesh, nearest.Distances, expected), shortestPath(mesh, distances, expected));
}

TEST(NearestTarget, IsNoneWhereAllWaysAreBlocked)
{
  const SurfaceMesh mesh = toSurfaceMesh(rectangleGrid(8, 8, 1.0));
  const Vertex last(static_cast<SurfaceMesh::size_type>(mesh.num_vertices() - 1));
  std::vector<char> blocked(mesh.num_vertices(), 0);
  for (const Vertex v : mesh.vertices())
  {
    const double x = mesh.point(v).x();
    blocked[v] = x > 0.4 && x < 0.6;
  }
  const auto isLast = [last](Vertex v) { return v == last; };
  EXPECT_FALSE(nearestTarget(mesh, Vertex(0), isLast, blocked).Vertex.is_valid());
  EXPECT_EQ(nearestTarget(mesh, Vertex(0), isLast, {}).Vertex, last);
}

} // namespace
