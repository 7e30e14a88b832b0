// SPDX-License-Identifier: GPL-3.0-or-later
/// No face of a conformal disk is flipped, for all shapes of the surface's triangles.
#include "AnalyticSurfaces.h"
#include "Base/Errors.h"
#include "Conformal/ConformalDisk.h"
#include "Disk/SurfaceToDisk.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"
#include "Support/RandomSurfaces.h"
#include "Support/SliverRefinement.h"

#include <gtest/gtest.h>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using namespace flattening::samples;

// Some seeds give surfaces that are no disks: this many give 500 disks.
constexpr int SurfaceCount = 590;
constexpr double GreatestCurvatureError = 1e-10;

struct SliverCase
{
  double LeastAngle; // degrees
  int Splits;
};

// The case in the test's name.
void PrintTo(const SliverCase& value, std::ostream* stream)
{
  *stream << value.Splits << " splits to " << value.LeastAngle << " degrees";
}

class ConformalSlivers : public testing::TestWithParam<SliverCase>
{
};

TEST_P(ConformalSlivers, AreNotFlipped)
{
  const RevolutionMesh smooth = sunflowerMesh(gaussianBump(1.0, 0.3), 4000);
  const TriangleMesh mesh = withRandomSlivers(smooth.Mesh, GetParam().Splits, GetParam().LeastAngle, 1);
  EXPECT_LT(smallestAngleOf(mesh), 1.2 * GetParam().LeastAngle);
  EXPECT_GE(smallestAngleOf(mesh), 0.99 * GetParam().LeastAngle);
  const std::vector<int> loop = requireDisk(mesh);
  const ConformalDiskMap map = conformalDiskMap(mesh, { -1, loop[5], {} });
  std::cout << mesh.faceCount() << " faces, " << map.Untangling.RepairedFaces << " flipped, "
            << map.Untangling.MovedVertices << " vertices moved, by " << map.Untangling.GreatestMove
            << " edges at most\n";
  EXPECT_EQ(map.Untangling.FlippedFaces, 0);
  EXPECT_EQ(countFlippedFaces(map.Positions, mesh.Faces), 0);
  EXPECT_GT(map.Untangling.RepairedFaces, 0) << "the surface is no test of untangling";
  EXPECT_LT(map.Untangling.MovedVertices, 2 * map.Untangling.RepairedFaces);
  for (const int v : loop)
  {
    EXPECT_NEAR(map.Positions.row(v).norm(), 1.0, 1e-15) << v;
  }
}

INSTANTIATE_TEST_SUITE_P(ConformalFlips,
  ConformalSlivers,
  testing::Values(SliverCase{ 1e-3, 1200 },
    SliverCase{ 1e-3, 4000 },
    SliverCase{ 1e-3, 12000 },
    SliverCase{ 1e-6, 1200 }));

TEST(ConformalFlips, UntanglingKeepsTheCentreAndTheBits)
{
  const TriangleMesh mesh =
    withRandomSlivers(sunflowerMesh(gaussianBump(1.0, 0.3), 1000).Mesh, 1000, 1e-3, 2);
  for (const int centre : { 3, mesh.vertexCount() - 1 })
  {
    const Points2 first = conformalDiskMap(mesh, { centre, -1, {} }).Positions;
    EXPECT_EQ(first.row(centre).norm(), 0.0);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE((conformalDiskMap(mesh, { centre, -1, {} }).Positions.array() == first.array()).all());
  }
}

struct SurfaceRecord
{
  std::string Name;
  bool IsDisk = true;
  std::string Error; // of the map
  double CurvatureError = 0.0;
  UntanglingReport Untangling;

  bool failed() const
  {
    return !this->Error.empty() || !(this->CurvatureError <= GreatestCurvatureError) ||
           this->Untangling.FlippedFaces > 0;
  }
};

void map(const TriangleMesh& disk, SurfaceRecord& record)
{
  try
  {
    const ConformalDiskMap map = conformalDiskMap(disk);
    record.Untangling = map.Untangling;
    record.CurvatureError = map.MaxCurvatureError;
  }
  catch (const FlatteningError& error)
  {
    record.Error = error.what();
  }
}

void mapRandomSurface(int seed, SurfaceRecord& record)
{
  record.Name = "random surface " + std::to_string(seed);
  SurfaceToDiskOptions options;
  options.CountSelfIntersections = false;
  TriangleMesh disk;
  try
  {
    const TriangleMesh surface = randomSurface(seed).Mesh;
    DiskSurface made = surfaceToDisk(surface, options);
    // A relief from a boundary can leave strips beside it in which points of the circle coincide in
    // double precision, so that faces have no area: no untangling could help, and a warning says so.
    if (made.Report.ReasonOfCut.find("has a boundary, but") != std::string::npos)
    {
      options.Cut = CutMode::Hole;
      made = surfaceToDisk(surface, options);
    }
    disk = std::move(made.Surface.Mesh);
  }
  catch (const FlatteningError&)
  {
    record.IsDisk = false; // a matter of another test
    return;
  }
  map(disk, record);
}

void mapCapsule(double length, SurfaceRecord& record)
{
  record.Name = "capsule of " + std::to_string(length) + " radii";
  map(sunflowerMesh(capsule(length), 3000).Mesh, record);
}

void mapSlivers(SurfaceRecord& record)
{
  record.Name = "slivers";
  map(withRandomSlivers(sunflowerMesh(gaussianBump(1.0, 0.3), 4000).Mesh, 4000, 1e-3, 1), record);
}

// Disks of random shape with random defects, tubes whose ends doubles do not resolve, and slivers.
TEST(ConformalFlips, EveryDiskHasAMapWithoutFlippedFaces)
{
  constexpr std::array<double, 5> capsules = { 3.0, 6.0, 10.0, 14.0, 30.0 };
  constexpr int count = SurfaceCount + static_cast<int>(capsules.size()) + 1;
  std::vector<SurfaceRecord> records(count);
  const auto mapNumber = [&](int i)
  {
    if (i < SurfaceCount)
    {
      mapRandomSurface(i, records[i]);
    }
    else if (i + 1 < count)
    {
      mapCapsule(capsules[i - SurfaceCount], records[i]);
    }
    else
    {
      mapSlivers(records[i]);
    }
  };
  tbb::parallel_for(
    tbb::blocked_range<int>(0, count, 1),
    [&](const tbb::blocked_range<int>& surfaces)
    {
      for (int i = surfaces.begin(); i < surfaces.end(); ++i)
      {
        tbb::this_task_arena::isolate([&] { mapNumber(i); });
      }
    },
    tbb::simple_partitioner());
  int disks = 0;
  int failures = 0;
  int before = 0;
  int after = 0;
  double curvatureError = 0.0;
  for (const SurfaceRecord& record : records)
  {
    EXPECT_FALSE(record.failed()) << record.Name << ": " << record.Error << ", curvature error "
                                  << record.CurvatureError << ", flipped "
                                  << record.Untangling.FlippedFaces;
    disks += record.IsDisk;
    failures += record.failed();
    before += record.Untangling.RepairedFaces + record.Untangling.FlippedFaces;
    after += record.Untangling.FlippedFaces;
    curvatureError = std::max(curvatureError, record.CurvatureError);
  }
  std::cout << disks << " disks, failures: " << failures << "; largest curvature error "
            << curvatureError << "; " << before << " faces flipped before untangling, " << after
            << " after it\n";
  EXPECT_GE(disks, 506);
  EXPECT_GT(before, 100) << "the surfaces are no test of untangling";
}

} // namespace
