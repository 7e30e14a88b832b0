// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/HandleRemoval.h"
#include "Handles/HomologyLabels.h"
#include "Handles/RejectedLoops.h"
#include "Handles/ShortLoops.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceComponents.h"
#include "Support/MarchingTetrahedra.h"
#include "Support/SampleSurfaces.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

TEST(ShortLoops, FindsTheMeridianOfATorusFromEverywhere)
{
  const TriangleMesh mesh = torus(48, 24);
  const HalfedgeSurface surface(mesh);
  const HomologyLabels labels(surface);
  ShortLoops loops(surface, labels);
  const double meridian = 24 * std::sin(Pi / 24); // a polygon around the tube, of radius 1/2
  EXPECT_TRUE(loops.find(loops.seeds(), 0.4 * meridian).empty());
  EXPECT_TRUE(loops.wasBounded());
  std::vector<SurfaceLoop> found = loops.find(loops.seeds(), meridian);
  ASSERT_FALSE(found.empty());
  for (SurfaceLoop& loop : found)
  {
    EXPECT_LE(loop.Length, 2.0 * meridian);
    EXPECT_NE(loops.classHash(loop), 0u);
    loops.tighten(loop);
    EXPECT_NEAR(loop.Length, meridian, 1e-12);
  }
  // Other loops beside it, along the tube, are not shorter.
  const std::vector<SurfaceLoop> beside = loops.findBeside(found[0], 1.1 * meridian);
  EXPECT_GE(beside.size(), 8u);
  for (const SurfaceLoop& loop : beside)
  {
    EXPECT_GE(loop.Length, (1.0 - 1e-12) * meridian);
    EXPECT_LE(loop.Length, 1.1 * meridian);
  }
  // Loops of a class that is ignored are not found.
  loops.Ignored = { loops.classHash(found[0]) };
  found = loops.find(loops.seeds(), meridian);
  EXPECT_TRUE(std::all_of(found.begin(),
    found.end(),
    [&](const SurfaceLoop& loop) { return !loops.Ignored.count(loops.classHash(loop)); }));
}

/// A ball of tubes that join in threes (Schoen 1970, the gyroid).
TriangleMesh gyroidBall(int half, double cell)
{
  Volume volume({ 2 * half + 3, 2 * half + 3, 2 * half + 3 });
  const double frequency = 2.0 * Pi / cell;
  for (int z = -half; z <= half; ++z)
  {
    for (int y = -half; y <= half; ++y)
    {
      for (int x = -half; x <= half; ++x)
      {
        const double u = frequency * x + 0.3;
        const double v = frequency * y + 0.1;
        const double w = frequency * z + 0.2;
        const double tubes = std::sin(u) * std::cos(v) + std::sin(v) * std::cos(w) +
                             std::sin(w) * std::cos(u) - 0.5 + 1e-3 * std::sin(0.7 * x + 1.1 * y + z);
        const double ball = (half - 1 - std::sqrt(x * x + y * y + z * z)) / cell;
        volume.at(x + half + 1, y + half + 1, z + half + 1) = std::min(tubes, ball);
      }
    }
  }
  const TriangleMesh mesh = marchingTetrahedra(volume);
  const SurfaceComponents components = connectedComponents(mesh);
  return extractFaces(mesh, components.faces(chooseComponent(mesh, components, {}))).Mesh;
}

TEST(HandleRemoval, DoesNotDependOnTheNumberOfThreads)
{
  const TriangleMesh mesh = gyroidBall(22, 12.0);
  const MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
  ASSERT_GT(topology.Genus, 20);
  std::vector<SurfaceWithoutHandles> results;
  for (const std::size_t threads : { 1, 2, 4 })
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(removeHandles(mesh));
  }
  EXPECT_EQ(results[0].Report.Handles, topology.Genus);
  const TriangleMesh& after = results[0].Surface.Mesh;
  EXPECT_EQ(analyseTopology(after.Faces, after.vertexCount()).eulerCharacteristic(), 2);
  for (const SurfaceWithoutHandles& other : results)
  {
    EXPECT_EQ(other.Report.LoopLengths, results[0].Report.LoopLengths);
    EXPECT_EQ(other.Surface.Mesh.Faces, results[0].Surface.Mesh.Faces);
    EXPECT_EQ(other.Surface.Mesh.Vertices, results[0].Surface.Mesh.Vertices);
  }
}

TEST(RejectedLoops, GiveTheCheapestWithinADetour)
{
  const auto loop = [](double length, int halfedge) { return SurfaceLoop{ length, { halfedge }, 0 }; };
  RejectedLoops rejected(10.0);
  EXPECT_EQ(rejected.due(1000.0, 1000.0), nullptr);
  EXPECT_EQ(rejected.limit(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(rejected.shortest(), 0.0);

  rejected.add(loop(12.0, 1), 40); // up to 18
  rejected.add(loop(17.0, 2), 33);
  rejected.add(loop(16.0, 3), 31); // costs 496, more than 480 and less than 561
  rejected.add(loop(30.0, 4), 1);
  EXPECT_EQ(rejected.shortest(), 12.0);
  EXPECT_EQ(rejected.limit(), 18.0);
  EXPECT_EQ(rejected.due(11.0, 100.0), nullptr); // not all as short as that were looked for
  EXPECT_EQ(rejected.due(12.0, 15.0), nullptr);  // not all within the detour were tried
  ASSERT_NE(rejected.due(12.0, 18.0), nullptr);
  EXPECT_EQ(rejected.due(12.0, 18.0)->Halfedges[0], 1);
  rejected.add(loop(15.0, 5), 32);
  rejected.add(loop(13.0, 6), 36);
  EXPECT_EQ(rejected.due(12.0, 18.0)->Halfedges[0], 6); // 468
  // A loop with few pairs does not wait for a longer one.
  rejected.keepIf([](const SurfaceLoop& l) { return l.Halfedges[0] == 3 || l.Halfedges[0] == 4; });
  EXPECT_EQ(rejected.limit(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(rejected.due(16.0, 16.0)->Halfedges[0], 3);
  // A detour from a long loop is 10 at most.
  rejected.keepIf([](const SurfaceLoop&) { return false; });
  rejected.add(loop(100.0, 7), 400);
  EXPECT_EQ(rejected.limit(), 110.0);
}

} // namespace
