// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/SurfaceToDisk.h"
#include "Mesh/MeshTopology.h"
#include "Repair/SpikeRemoval.h"
#include "Support/SampleSurfaces.h"

#include <cmath>
#include <functional>
#include <map>

namespace
{

using namespace flattening;
using namespace flattening::samples;

const double RowHeight = std::sqrt(0.75);

// A hexagon of unit triangles in the plane z = 0, up to @p rings edges around its centre; its vertices
// are raised to height(column, row), columns and rows counted from the centre.
TriangleMesh hexagon(int rings, const std::function<double(int, int)>& height)
{
  std::map<std::pair<int, int>, int> index;
  std::vector<std::array<double, 3>> points;
  const auto inside = [rings](int c, int r)
  { return std::abs(c) <= rings && std::abs(r) <= rings && std::abs(c + r) <= rings; };
  for (int r = -rings; r <= rings; ++r)
  {
    for (int c = -rings; c <= rings; ++c)
    {
      if (inside(c, r))
      {
        index[{ c, r }] = static_cast<int>(points.size());
        points.push_back({ c + 0.5 * r, RowHeight * r, height(c, r) });
      }
    }
  }
  std::vector<std::array<int, 3>> faces;
  for (const auto& [place, v] : index)
  {
    const auto [c, r] = place;
    if (inside(c + 1, r) && inside(c, r + 1))
    {
      faces.push_back({ v, index[{ c + 1, r }], index[{ c, r + 1 }] });
    }
    if (inside(c + 1, r) && inside(c + 1, r - 1))
    {
      faces.push_back({ v, index[{ c + 1, r - 1 }], index[{ c + 1, r }] });
    }
  }
  return meshOf(points, faces);
}

TriangleMesh hexagonWithSpike(double height)
{
  return hexagon(2, [height](int c, int r) { return c == 0 && r == 0 ? height : 0.0; });
}

// A roof along the middle row.
TriangleMesh hexagonWithFin(int rings, int length, double height)
{
  return hexagon(rings, [=](int c, int r) { return r == 0 && c >= 0 && c < length ? height : 0.0; });
}

TEST(SpikeRemoval, ASurfaceWithoutFoldsStaysAsItIs)
{
  for (const TriangleMesh& input : { sphere(3), torus(30, 20), cylinder(20, 8, 3.0) })
  {
    TriangleMesh mesh = input;
    const FlattenedFolds folds = flattenSpikesAndFins(mesh);
    EXPECT_EQ(folds.Spikes + folds.Fins + folds.LeftFolded, 0);
    EXPECT_EQ(folds.AreaChange, 0.0);
    EXPECT_EQ(mesh.Vertices, input.Vertices);
  }
}

// The spike has six triangles of the altitude sqrt(a^2 + h^2) over a hexagon of the altitude a: its
// flatness is 1/3 at h = a sqrt 8.
TEST(SpikeRemoval, FlattensSpikesAndPitsThatAreSteepEnough)
{
  const double bound = RowHeight * std::sqrt(8.0);
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    for (const double height : { 0.99 * bound, 1.01 * bound, -0.99 * bound, -1.01 * bound, 50.0 })
    {
      TriangleMesh mesh = hexagonWithSpike(height);
      mesh.Vertices *= scale;
      const TriangleMesh before = mesh;
      const FlattenedFolds folds = flattenSpikesAndFins(mesh);
      const bool steep = std::abs(height) > bound;
      EXPECT_EQ(folds.Spikes, steep ? 1 : 0) << height;
      EXPECT_EQ(folds.Fins + folds.LeftFolded, 0) << height;
      const double change = steep ? 3.0 * (RowHeight - std::hypot(RowHeight, height)) : 0.0;
      EXPECT_NEAR(folds.AreaChange / (scale * scale), change, 1e-12 * std::abs(height)) << height;
      EXPECT_EQ(mesh.Faces, before.Faces);
      const TriangleMesh& expected = steep ? hexagonWithSpike(0.0) : hexagonWithSpike(height);
      EXPECT_LT((mesh.Vertices / scale - expected.Vertices).cwiseAbs().maxCoeff(), 1e-12) << height;
    }
  }
}

TEST(SpikeRemoval, FlattensFinsOfOneVoxelButNoSheets)
{
  TriangleMesh mesh = hexagonWithFin(8, 5, 3.0);
  const double area = totalArea(mesh);
  FlattenedFolds folds = flattenSpikesAndFins(mesh);
  EXPECT_EQ(folds.Fins, 1);
  EXPECT_EQ(folds.Spikes + folds.LeftFolded, 0);
  EXPECT_NEAR(totalArea(mesh), 6 * 64 * 0.5 * RowHeight, 1e-4);
  EXPECT_NEAR(folds.AreaChange, totalArea(mesh) - area, 1e-12 * area);
  EXPECT_LT(mesh.Vertices.col(2).maxCoeff(), 0.02);

  const TriangleMesh sheet = hexagonWithFin(30, 25, 3.0);
  mesh = sheet;
  folds = flattenSpikesAndFins(mesh);
  EXPECT_EQ(folds.Spikes + folds.Fins, 0);
  EXPECT_EQ(folds.LeftFolded, 1);
  EXPECT_EQ(mesh.Vertices, sheet.Vertices);
}

// A needle stands in the pit, which would be closed through it.
TEST(SpikeRemoval, MakesNoFacesIntersect)
{
  const TriangleMesh pit = hexagonWithSpike(-4.0);
  const TriangleMesh needle =
    meshOf({ { 0.1, 0.1, -1 }, { 0.2, 0.1, -1 }, { 0.1, 0.2, 1 } }, { { 0, 1, 2 } });
  TriangleMesh mesh = both(pit, needle);
  const TriangleMesh before = mesh;
  FlattenedFolds folds = flattenSpikesAndFins(mesh);
  EXPECT_EQ(folds.Spikes, 0);
  EXPECT_EQ(folds.LeftFolded, 1);
  EXPECT_EQ(folds.AreaChange, 0.0);
  EXPECT_EQ(mesh.Vertices, before.Vertices);

  mesh = both(pit, moved(needle, 10, 0, 0)); // beside the pit it does not matter
  folds = flattenSpikesAndFins(mesh);
  EXPECT_EQ(folds.Spikes, 1);
}

// A spike on the boundary has nothing to be flattened into.
TEST(SpikeRemoval, KeepsTheBoundary)
{
  TriangleMesh mesh = hexagonWithSpike(9.0);
  std::vector<int> star;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    if ((mesh.Faces.row(f).array() == 9).any()) // the centre
    {
      star.push_back(f);
    }
  }
  ASSERT_EQ(star.size(), 6u);
  const std::set<int> removed{ star[0] };
  mesh = withoutFaces(mesh, removed);
  const TriangleMesh before = mesh;
  EXPECT_EQ(flattenSpikesAndFins(mesh).Spikes, 0);
  EXPECT_EQ(mesh.Vertices, before.Vertices);
}

TEST(SpikeRemoval, FoldsAreFlattenedOnTheWayToADisk)
{
  TriangleMesh input = sphere(3);
  input.Vertices.row(100) *= 2.0;
  input.Vertices.row(300) *= 0.2;
  SurfaceToDiskOptions options;
  SurfaceToDiskReport report = surfaceToDisk(input, options).Report;
  EXPECT_EQ(report.Folds.Spikes, 2);
  EXPECT_NEAR(report.SurfaceArea + report.RemovedArea, totalArea(sphere(3)), 0.01);

  options.Handles = HandleMode::Keep; // no change of geometry
  EXPECT_EQ(surfaceToDisk(input, options).Report.Folds.Spikes, 0);
  options = {};
  options.FlattenFolds = false;
  report = surfaceToDisk(input, options).Report;
  EXPECT_EQ(report.Folds.Spikes, 0);
  EXPECT_GT(report.SurfaceArea, totalArea(sphere(3)) + 0.1);
}

// Two triangles and their two backs: each of the four points is the tip of a fold.
TEST(SpikeRemoval, KeepsASurfaceThatIsAllFolds)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(4, 3);
  mesh.Vertices << 0.4, 0.0, 5.5, //
    -0.6, 0.0, 5.3,               //
    -0.2, 0.0, 0.0,               //
    0.8, 0.0, 0.0;
  mesh.Faces.resize(4, 3);
  mesh.Faces << 0, 1, 2, 0, 2, 3, 1, 0, 3, 1, 3, 2;
  const TriangleMesh before = mesh;
  EXPECT_EQ(flattenSpikesAndFins(mesh).Spikes, 0);
  EXPECT_EQ(mesh.Vertices, before.Vertices);
  EXPECT_GT(surfaceToDisk(before, {}).Report.SurfaceArea, 1.0);
}

} // namespace
