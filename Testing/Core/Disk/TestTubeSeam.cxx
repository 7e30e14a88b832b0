// SPDX-License-Identifier: GPL-3.0-or-later
/// Open tubes cut from end to end, and the rectangle that they unroll to.
#include "Conformal/ConformalRectangle.h"
#include "Disk/SurfaceToDisk.h"
#include "Disk/TubeSeam.h"
#include "Mesh/MeshTopology.h"
#include "Support/RandomNumbers.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// Moves inner vertices along the cylinder by a share of the edges.
TriangleMesh roughCylinder(int around, int along, double length, int seed = 7)
{
  TriangleMesh mesh = cylinder(around, along, length);
  RandomNumbers random(seed);
  for (int v = around; v < mesh.vertexCount() - around; ++v)
  {
    const double angle =
      std::atan2(mesh.Vertices(v, 1), mesh.Vertices(v, 0)) + random.real(-0.3, 0.3) * 2.0 * Pi / around;
    const double z = mesh.Vertices(v, 2) + random.real(-0.3, 0.3) * length / along;
    mesh.Vertices.row(v) << std::cos(angle), std::sin(angle), z;
  }
  return mesh;
}

DiskSurface cutTube(const TriangleMesh& mesh)
{
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Seam;
  options.SmallestAngle = 0.0;
  return surfaceToDisk(mesh, options);
}

ConformalRectangleMap unrolled(const DiskSurface& disk)
{
  ConformalRectangleOptions options;
  options.Corners = seamCorners(disk.Surface.Mesh, requireDisk(disk.Surface.Mesh), disk.Seam);
  EXPECT_EQ(options.Corners.size(), 4u);
  return conformalRectangleMap(disk.Surface.Mesh, options);
}

struct Tube
{
  double Length;
  int Around;
  int Along;
  double Tolerance; // of the modulus, relative: the square of the edge length
};

// The name of a test's parameters.
void PrintTo(const Tube& value, std::ostream* stream)
{
  *stream << value.Length << " radii, " << value.Around << " by " << value.Along << " edges";
}

class TubeSeam : public testing::TestWithParam<Tube>
{
};

TEST_P(TubeSeam, ModulusIsLengthOverCircumference)
{
  const Tube tube = GetParam();
  const TriangleMesh mesh = roughCylinder(tube.Around, tube.Along, tube.Length);
  const DiskSurface disk = cutTube(mesh);
  EXPECT_EQ(disk.Report.FilledHoles, 0);
  EXPECT_EQ(disk.Report.RemovedArea, 0.0);
  EXPECT_NEAR(disk.Report.SurfaceArea, faceAreas(mesh.Vertices, mesh.Faces).sum(), 1e-9);
  EXPECT_NEAR(disk.Report.SeamLength, tube.Length, 0.03 * tube.Length)
    << "along the tube, but through vertices that are near";
  const ConformalRectangleMap map = unrolled(disk);
  const double expected = tube.Length / (2.0 * Pi);
  std::cout << disk.Surface.Mesh.vertexCount() << " vertices: seam " << disk.Report.SeamLength
            << ", modulus " << map.Modulus << ", exactly " << expected << '\n';
  EXPECT_NEAR(map.Modulus / expected, 1.0, tube.Tolerance);
  EXPECT_LE(map.Map.MaxCurvatureError, 1e-10);
  EXPECT_EQ(map.Map.Untangling.FlippedFaces, 0);
}

INSTANTIATE_TEST_SUITE_P(TubeSeam,
  TubeSeam,
  testing::Values(Tube{ 6.0, 40, 40, 1e-2 }, Tube{ 6.0, 80, 80, 2.5e-3 }, Tube{ 30.0, 40, 150, 1e-2 }));

// The mesh is a prism, which unrolls exactly wherever it is cut.
TEST(TubeSeam, APrismUnrollsToItself)
{
  constexpr int around = 36;
  const DiskSurface disk = cutTube(cylinder(around, 30, 6.0));
  const ConformalRectangleMap map = unrolled(disk);
  EXPECT_NEAR(map.Modulus, 6.0 / (around * 2.0 * std::sin(Pi / around)), 1e-9);
}

// A bent tube whose ends are of different size: the seam is on the inner side of the bend, the lower
// side of the rectangle starts at the longer end.
TEST(TubeSeam, RunsAlongTheInsideOfABend)
{
  constexpr int around = 60;
  TriangleMesh mesh = cylinder(around, 60, 1.0);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double bend = Pi * mesh.Vertices(v, 2);
    const double radius = 1.0 - 0.5 * mesh.Vertices(v, 2);
    const double r = 4.0 + radius * mesh.Vertices(v, 0);
    const double z = radius * mesh.Vertices(v, 1);
    mesh.Vertices.row(v) << r * std::cos(bend), r * std::sin(bend), z;
  }
  const DiskSurface disk = cutTube(mesh);
  const TriangleMesh& cut = disk.Surface.Mesh;
  EXPECT_GT(disk.Report.SeamLength, 9.0);
  const std::vector<int> corners = seamCorners(cut, requireDisk(cut), disk.Seam);
  ASSERT_EQ(corners.size(), 4u);
  for (int v = 0; v < cut.vertexCount(); ++v)
  {
    if (disk.Seam[v])
    {
      ASSERT_LT(cut.Vertices.row(v).head<2>().norm(), 4.0) << v;
    }
  }
  for (const int k : { 0, 3 })
  {
    EXPECT_NEAR(cut.Vertices(corners[k], 1), 0.0, 1e-9) << "the wide end";
  }
  EXPECT_EQ(unrolled(disk).Map.Untangling.FlippedFaces, 0);
}

// The seam ends at new vertices of the boundary, beside which edges are flipped before it is cut.
TEST(TubeSeam, CoarseTubesBecomeDisks)
{
  for (int seed = 0; seed < 100; ++seed)
  {
    const int around = 3 + seed % 10;
    const TriangleMesh mesh = roughCylinder(around, 2 + seed % 7, 6.0, seed);
    const DiskSurface disk = cutTube(mesh);
    EXPECT_NO_THROW(requireDisk(disk.Surface.Mesh)) << seed;
    EXPECT_NEAR(disk.Report.SurfaceArea, faceAreas(mesh.Vertices, mesh.Faces).sum(), 1e-9) << seed;
    EXPECT_GT(disk.Report.SeamLength, 4.0) << seed;
  }
}

TEST(TubeSeam, OtherBoundariesAreNoEnds)
{
  const TriangleMesh mesh = cylinder(40, 40, 6.0);
  const std::vector<std::vector<int>> loops =
    analyseTopology(mesh.Faces, mesh.vertexCount()).BoundaryLoops;
  EXPECT_EQ(endsOfTube(mesh.Vertices, loops), (std::vector<int>{ 0, 1 }));
  EXPECT_TRUE(endsOfTube(mesh.Vertices, { loops[0] }).empty());
  TriangleMesh cone = mesh;
  for (int v = 0; v < cone.vertexCount(); ++v)
  {
    cone.Vertices.row(v).head<2>() *= 1.0 - 0.8 * cone.Vertices(v, 2) / 6.0;
  }
  EXPECT_TRUE(endsOfTube(cone.Vertices, loops).empty()) << "an end of a fifth of the other";
  const DiskSurface disk = cutTube(cone);
  EXPECT_EQ(disk.Report.FilledHoles, 1);
  EXPECT_EQ(disk.Report.SeamLength, 0.0);
  EXPECT_TRUE(seamCorners(disk.Surface.Mesh, requireDisk(disk.Surface.Mesh), disk.Seam).empty());
}

} // namespace
