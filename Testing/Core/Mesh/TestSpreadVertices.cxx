// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Base/Errors.h"
#include "Geodesics/DijkstraDistance.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SpreadVertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

// The distances are computed anew, by another implementation.
TEST(SpreadVertices, AreAsFarFromEachOtherAsAskedForAndNotFarther)
{
  constexpr double spacing = 0.15;
  const TriangleMesh mesh = sunflowerMesh(gaussianBump(1.0, 0.35), 4000).Mesh;
  const std::vector<int> loop = requireDisk(mesh);
  const std::vector<int> chosen = spreadVertices(mesh, loop, spacing);
  ASSERT_GT(chosen.size(), loop.size() + 100);
  EXPECT_TRUE(std::equal(loop.begin(), loop.end(), chosen.begin()));
  EXPECT_TRUE(std::is_sorted(chosen.begin() + static_cast<std::ptrdiff_t>(loop.size()), chosen.end()));
  const SurfaceMesh surface = toSurfaceMesh(mesh);
  using Vertex = SurfaceMesh::Vertex_index;
  std::vector<Vertex> boundary;
  for (const int v : loop)
  {
    boundary.emplace_back(static_cast<SurfaceMesh::size_type>(v));
  }
  const Eigen::VectorXd fromBoundary = distancesAlongEdges(surface, boundary);
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(mesh.vertexCount(), HUGE_VAL);
  for (std::size_t k = loop.size(); k < chosen.size(); ++k)
  {
    const int v = chosen[k];
    const double asked = std::min(spacing, 0.7 * fromBoundary[v]);
    const Eigen::VectorXd distances =
      distancesAlongEdges(surface, { Vertex(static_cast<SurfaceMesh::size_type>(v)) });
    for (std::size_t other = k + 1; other < chosen.size(); ++other)
    {
      EXPECT_GE(distances[chosen[other]], asked - 1e-12);
    }
    nearest = nearest.cwiseMin(distances);
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_LT(std::min(nearest[v], fromBoundary[v]), spacing + 1e-12) << v;
  }
}

TEST(SpreadVertices, BecomeFewerByTheSquareOfTheDistance)
{
  const TriangleMesh mesh = sunflowerMesh(flatDisk(), 20000).Mesh;
  const std::vector<int> loop = requireDisk(mesh);
  const auto countWithin = [&](double radius, double spacing)
  {
    const std::vector<int> chosen = spreadVertices(mesh, loop, spacing);
    return static_cast<double>(std::count_if(
      chosen.begin(), chosen.end(), [&](int v) { return mesh.Vertices.row(v).norm() < radius; }));
  };
  EXPECT_NEAR(countWithin(0.6, 0.05) / countWithin(0.6, 0.1), 4.0, 0.4);
  EXPECT_EQ(countWithin(2.0, 1e-9), mesh.vertexCount()); // all
}

TEST(SpreadVertices, CanBeCancelled)
{
  const TriangleMesh mesh = sunflowerMesh(flatDisk(), 500).Mesh;
  EXPECT_THROW(
    spreadVertices(mesh, requireDisk(mesh), 0.1, [](double, const char*) { return false; }), Cancelled);
}

} // namespace
