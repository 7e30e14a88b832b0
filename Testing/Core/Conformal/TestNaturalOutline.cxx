// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Conformal/NaturalOutline.h"
#include "FlatMap/DistortionMeasures.h"
#include "FlatMap/DistortionSummary.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/OutlineCrossings.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

// The cap of a unit sphere up to the polar angle a: the map with the natural outline is the
// stereographic projection with the boundary's length kept, r = 2 cos^2(a / 2) tan(theta / 2).
TEST(NaturalOutline, OfASphericalCapIsTheStereographicProjection)
{
  const double angle = 1.2;
  const TriangleMesh cap = sunflowerMesh(sphericalCap(angle), 8000).Mesh;
  const std::vector<int> loop = requireDisk(cap);
  NaturalOutlineMap map(cap, loop);
  Points2 positions = map.extended(map.outline());
  positions.rowwise() -= positions(loop, Eigen::indexing::all).colwise().mean();
  const double scale = 2.0 * std::pow(std::cos(0.5 * angle), 2);
  const double top = cap.Vertices.col(2).maxCoeff();
  double greatest = 0.0;
  for (int v = 0; v < cap.vertexCount(); ++v)
  {
    const double theta = std::acos(std::clamp(1.0 - (top - cap.Vertices(v, 2)), -1.0, 1.0));
    greatest = std::max(greatest, std::abs(positions.row(v).norm() - scale * std::tan(0.5 * theta)));
  }
  EXPECT_LT(greatest, 0.01); // of a radius of 0.93
}

// With the roundness 1 the outline is a convex polygon that turns once.
TEST(NaturalOutline, GetsRound)
{
  TriangleMesh sheet = sunflowerMesh(flatDisk(), 2000).Mesh;
  sheet.Vertices.col(0) *= 3.0;
  const std::vector<int> loop = requireDisk(sheet);
  NaturalOutlineMap map(sheet, loop);
  const Points2 round = map.outline(1.0);
  const auto count = static_cast<int>(loop.size());
  for (int k = 0; k < count; ++k)
  {
    const Eigen::RowVector2d in = round.row((k + 1) % count) - round.row(k);
    const Eigen::RowVector2d out = round.row((k + 2) % count) - round.row((k + 1) % count);
    EXPECT_GT(in[0] * out[1] - in[1] * out[0], 0.0);
  }
}

// The natural outline of a flat surface is simple and comes first; a quarter, half, three quarters of a
// convex polygon and all of it follow.
TEST(NaturalOutline, MapsNearItGetRounder)
{
  TriangleMesh sheet = sunflowerMesh(flatDisk(), 1000).Mesh;
  sheet.Vertices.col(0) *= 3.0;
  const std::vector<int> loop = requireDisk(sheet);
  MapsNearNaturalOutline maps(sheet, loop);
  double before = 0.0;
  for (int k = 0; k < 5; ++k)
  {
    const std::optional<Points2> map = maps.next();
    ASSERT_TRUE(map) << k;
    EXPECT_EQ(countFlippedFaces(*map, sheet.Faces), 0) << k;
    const Points2 centred = map->rowwise() - map->colwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> moments(centred.transpose() * centred);
    const double roundness = moments.eigenvalues()[0] / moments.eigenvalues()[1]; // 1 of a circle
    EXPECT_GT(roundness, before) << k;
    before = roundness;
  }
  EXPECT_GT(before, 0.5); // 0.11 of the ellipse
  EXPECT_FALSE(maps.next());
}

// A flat surface is its own map, up to where it lies.
TEST(NaturalOutline, OfAFlatSurfaceKeepsLengths)
{
  TriangleMesh sheet = sunflowerMesh(flatDisk(), 2000).Mesh;
  sheet.Vertices.col(0) *= 3.0;
  const std::vector<int> loop = requireDisk(sheet);
  const std::optional<Points2> map = MapsNearNaturalOutline(sheet, loop).next();
  ASSERT_TRUE(map);
  for (int f = 0; f < sheet.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = sheet.Faces(f, k);
      const int b = sheet.Faces(f, (k + 1) % 3);
      const double length = (sheet.Vertices.row(a) - sheet.Vertices.row(b)).norm();
      EXPECT_NEAR((map->row(a) - map->row(b)).norm(), length, 1e-9);
    }
  }
}

// Along a closed tube the conformal scale falls to 1e-17, where doubles do not tell points apart.
TEST(NaturalOutline, SpreadsProtrusions)
{
  const TriangleMesh tube = sunflowerMesh(capsule(40.0), 3000).Mesh;
  const std::optional<Points2> map = MapsNearNaturalOutline(tube, requireDisk(tube)).next();
  ASSERT_TRUE(map);
  EXPECT_EQ(countFlippedFaces(*map, tube.Faces), 0);
}

// A strip that winds twice around an axis and rises: unrolled it would overlap itself.
TEST(NaturalOutline, IsMadeRounderWhereItCrossesItself)
{
  constexpr int columns = 200;
  constexpr int rows = 6;
  TriangleMesh strip;
  strip.Vertices.resize((columns + 1) * (rows + 1), 3);
  strip.Faces.resize(2 * columns * rows, 3);
  int face = 0;
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const double turn = 4.5 * EIGEN_PI * i / columns;
      const double radius = 1.0 + 0.5 * j / rows;
      const int v = j * (columns + 1) + i;
      strip.Vertices.row(v) << radius * std::cos(turn), radius * std::sin(turn), 0.01 * i / columns;
      if (i < columns && j < rows)
      {
        const int up = v + columns + 1;
        strip.Faces.row(face++) << v, up + 1, v + 1;
        strip.Faces.row(face++) << v, up, up + 1;
      }
    }
  }
  const std::vector<int> loop = requireDisk(strip);
  NaturalOutlineMap natural(strip, loop);
  std::vector<int> polygon(loop.size());
  std::iota(polygon.begin(), polygon.end(), 0);
  EXPECT_FALSE(isSimpleOutline(natural.outline(), polygon));
  const std::optional<Points2> map = MapsNearNaturalOutline(strip, loop).next();
  ASSERT_TRUE(map);
  EXPECT_EQ(countFlippedFaces(*map, strip.Faces), 0);
  EXPECT_TRUE(isSimpleOutline(*map, loop));
}

} // namespace
