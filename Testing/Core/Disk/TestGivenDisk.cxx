// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/GivenDisk.h"

#include "Disk/SurfaceToDisk.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// A sphere that was cut open along a seam.
DiskSurface seamed()
{
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Seam;
  return surfaceToDisk(sphere(4), options);
}

TEST(GivenDisk, TellsDisksFromOthers)
{
  EXPECT_TRUE(isDisk(seamed().Surface.Mesh));
  EXPECT_TRUE(isDisk(withoutFaces(sphere(2), { 0 })));
  EXPECT_FALSE(isDisk(sphere(2))) << "closed";
  EXPECT_FALSE(isDisk(cylinder(12, 4, 1.0))) << "two boundaries";
  EXPECT_FALSE(isDisk(soupOf(seamed().Surface.Mesh))) << "no triangle is joined to another";
  EXPECT_FALSE(isDisk(both(seamed().Surface.Mesh, moved(seamed().Surface.Mesh, 3.0, 0.0, 0.0))));
  TriangleMesh flat = seamed().Surface.Mesh;
  flat.Vertices.row(flat.Faces(0, 1)) = flat.Vertices.row(flat.Faces(0, 0));
  EXPECT_FALSE(isDisk(flat)) << "a triangle without area";
}

TEST(GivenDisk, WithItsSeamPassesUnchanged)
{
  const DiskSurface disk = seamed();
  SurfaceToDiskOptions options;
  options.Banks = disk.Seam;
  const DiskSurface again = surfaceToDisk(disk.Surface.Mesh, options);
  EXPECT_EQ(again.Surface.Mesh.Vertices, disk.Surface.Mesh.Vertices);
  EXPECT_EQ(again.Surface.Mesh.Faces, disk.Surface.Mesh.Faces);
  EXPECT_EQ(again.Seam, disk.Seam);
  EXPECT_EQ(again.SeamPoint.size(), disk.SeamPoint.size());
  EXPECT_EQ(again.Boundary, disk.Boundary);
  EXPECT_EQ(again.Report.Repair.MergedPoints, 0);
  EXPECT_EQ(again.Report.RemovedArea, 0.0);
  EXPECT_EQ(again.Report.Components, 1);
}

// Read from a file that has no array Seam: the shape alone tells.
TEST(GivenDisk, KeepsTheBanksOfAnUnknownSeamApart)
{
  const DiskSurface disk = seamed();
  const DiskSurface again = surfaceToDisk(disk.Surface.Mesh, {});
  EXPECT_EQ(again.Report.Repair.MergedPoints, 0);
  EXPECT_FALSE(again.Report.ChosenCut);
  EXPECT_NEAR(again.Report.SurfaceArea, disk.Report.SurfaceArea, 1e-6 * disk.Report.SurfaceArea);
  EXPECT_NEAR(again.Report.BoundaryLength, disk.Report.BoundaryLength, 1e-6);
}

// Two thirds of the seamed sphere, with a hole far from the seam, are no disk: the flags alone tell.
TEST(GivenDisk, KeepsTheBanksOfASeamApartOnOtherSurfaces)
{
  const DiskSurface disk = seamed();
  const TriangleMesh& mesh = disk.Surface.Mesh;
  int far = -1;
  for (int f = 0; f < mesh.faceCount() && far < 0; ++f)
  {
    bool onBorder = false;
    for (int k = 0; k < 3; ++k)
    {
      for (const int v : disk.Boundary)
      {
        onBorder |= (mesh.Vertices.row(v) - mesh.Vertices.row(mesh.Faces(f, k))).norm() < 0.3;
      }
    }
    far = onBorder ? -1 : f;
  }
  ASSERT_GE(far, 0);
  const TriangleMesh holed = withoutFaces(mesh, { far });
  ASSERT_EQ(holed.vertexCount(), mesh.vertexCount());
  SurfaceToDiskOptions options;
  options.Banks = disk.Seam;
  const DiskSurface again = surfaceToDisk(holed, options);
  EXPECT_EQ(again.Report.Repair.MergedPoints, 0);
  EXPECT_EQ(again.Report.FilledHoles, 1);
  EXPECT_NEAR(again.Report.BoundaryLength, disk.Report.BoundaryLength, 1e-6);
  options.Banks.clear();
  EXPECT_GT(surfaceToDisk(holed, options).Report.Repair.MergedPoints, 0) << "nothing tells of the seam";
}

// The wall of a cylinder, open along a slit that is much narrower than the tolerance.
TEST(GivenDisk, IsMergedIfAToleranceIsAsked)
{
  constexpr int around = 24;
  TriangleMesh wall = liftedGrid(around,
    [](double x, double y)
    {
      const double angle = 2.0 * Pi * x * (1.0 - 1e-6);
      return Eigen::Vector3d(std::cos(angle), std::sin(angle), y);
    });
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Seam;
  EXPECT_EQ(surfaceToDisk(wall, options).Report.Repair.MergedPoints, 0);
  options.MergeTolerance = 1e-3;
  const DiskSurface disk = surfaceToDisk(wall, options);
  EXPECT_EQ(disk.Report.Repair.MergedPoints, around + 1);
  EXPECT_EQ(disk.Report.ChosenCut, CutMode::Seam) << "of a tube";
}

TEST(GivenDisk, IsRemeshedIfAsked)
{
  const DiskSurface disk = seamed();
  SurfaceToDiskOptions options;
  options.Banks = disk.Seam;
  options.Remesh = true;
  options.RelativeEdgeLength = 1.5;
  const DiskSurface coarser = surfaceToDisk(disk.Surface.Mesh, options);
  EXPECT_LT(coarser.Surface.Mesh.faceCount(), disk.Surface.Mesh.faceCount());
  EXPECT_NEAR(
    coarser.Report.BoundaryLength, disk.Report.BoundaryLength, 0.02 * disk.Report.BoundaryLength);
}

TEST(GivenDisk, FlagsMustFit)
{
  SurfaceToDiskOptions options;
  options.Banks.assign(7, 1);
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { surfaceToDisk(sphere(2), options); }), "7 flags"));
}

} // namespace
