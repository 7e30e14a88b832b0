// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/RoughFreeMap.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/OutlineCrossings.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

// The standard deviation of the ratios of lengths on the map to lengths on the surface, over all edges,
// as a share of their mean.
double deviationOfLengths(const TriangleMesh& surface, const Points2& map)
{
  std::vector<double> ratios;
  double sum = 0.0;
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int i = surface.Faces(f, k);
      const int j = surface.Faces(f, (k + 1) % 3);
      ratios.push_back(
        (map.row(i) - map.row(j)).norm() / (surface.Vertices.row(i) - surface.Vertices.row(j)).norm());
      sum += ratios.back();
    }
  }
  const double mean = sum / static_cast<double>(ratios.size());
  double squares = 0.0;
  for (const double ratio : ratios)
  {
    squares += (ratio / mean - 1.0) * (ratio / mean - 1.0);
  }
  return std::sqrt(squares / static_cast<double>(ratios.size()));
}

// A flat disk whose chart is a whirl: a coarse disk in it has long and narrow triangles on the surface.
TEST(RoughFreeMap, OfAFlatDiskUndoesAPoorChart)
{
  const TriangleMesh surface = sunflowerMesh(flatDisk(), 8000).Mesh;
  const std::vector<int> loop = requireDisk(surface);
  Points2 chart(surface.vertexCount(), 2);
  for (int v = 0; v < surface.vertexCount(); ++v)
  {
    const Eigen::Vector2d point = surface.Vertices.row(v).head<2>();
    chart.row(v) = Eigen::Rotation2D<double>(2.0 * point.norm()) * point;
  }
  ASSERT_EQ(countFlippedFaces(chart, surface.Faces), 0);
  EXPECT_GT(deviationOfLengths(surface, chart), 0.35);
  const std::optional<Points2> map =
    roughFreeMap(surface, loop, chart, faceAreas(surface.Vertices, surface.Faces), 1e-3);
  ASSERT_TRUE(map);
  EXPECT_EQ(countFlippedFaces(*map, surface.Faces), 0);
  EXPECT_TRUE(isSimpleOutline(*map, loop));
  EXPECT_LT(deviationOfLengths(surface, *map), 0.065); // 0.054, and 0.086 with a single coarse disk
}

} // namespace
