// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/LongestEdgeBisection.h"
#include "Support/SampleSurfaces.h"

#include <cmath>

namespace
{

using namespace flattening;
using namespace flattening::samples;

TEST(LongestEdgeBisection, AddsVerticesToTheLongestLoopAlone)
{
  TriangleMesh tube = cylinder(20, 6, 3.0);
  for (int v = 0; v < tube.vertexCount(); ++v)
  {
    tube.Vertices.row(v).head<2>() *= 1.0 + 0.1 * tube.Vertices(v, 2);
  }
  const DerivedMesh refined = refineBoundary(tube, 128);
  const auto loops = analyseTopology(refined.Mesh.Faces, refined.Mesh.vertexCount()).BoundaryLoops;
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_GE(loops[0].size(), 128u);
  EXPECT_LE(loops[0].size(), 256u);
  EXPECT_NEAR(loopLength(refined.Mesh.Vertices, loops[0]), 1.3 * 40.0 * std::sin(Pi / 20), 1e-12);
  EXPECT_LT(loops[1].size(), 40u);
  EXPECT_NEAR(totalArea(refined.Mesh), totalArea(tube), 1e-12);
  EXPECT_GE(smallestAngle(refined.Mesh), 0.5 * smallestAngle(tube));
  EXPECT_LT((refined.Vertices * tube.Vertices - refined.Mesh.Vertices).cwiseAbs().maxCoeff(), 1e-13);

  EXPECT_EQ(refineBoundary(tube, 20).Mesh.Faces, tube.Faces);
  EXPECT_EQ(refineBoundary(sphere(2), 128).Mesh.Faces, sphere(2).Faces);
}

// Fourteen faces from a small loop to a far tip: bisecting them would make 23,000. Each side is 4.6
// times as long as allowed and is halved three times.
TEST(LongestEdgeBisection, HalvesTheBoundaryAloneWhereFacesReachFar)
{
  TriangleMesh needles;
  needles.Vertices = Points3::Zero(15, 3);
  needles.Vertices(14, 2) = 30.0;
  needles.Faces.resize(14, 3);
  for (int v = 0; v < 14; ++v)
  {
    needles.Vertices.row(v) << std::cos(2.0 * Pi * v / 14.0), std::sin(2.0 * Pi * v / 14.0), 0.0;
    needles.Faces.row(v) << v, (v + 1) % 14, 14;
  }
  const DerivedMesh refined = refineBoundary(needles, 64);
  const std::vector<int> loop = requireDisk(refined.Mesh);
  EXPECT_EQ(loop.size(), 14u * 8u);
  EXPECT_EQ(refined.Mesh.faceCount(), 14 * 8);
  EXPECT_NEAR(loopLength(refined.Mesh.Vertices, loop), 28.0 * std::sin(Pi / 14.0), 1e-12);
  EXPECT_NEAR(totalArea(refined.Mesh), totalArea(needles), 1e-10);
}

TEST(LongestEdgeBisection, EndsWhereDoublePrecisionDoes)
{
  TriangleMesh tube = cylinder(20, 6, 3.0);
  tube.Vertices.col(0).array() += 1e14;
  EXPECT_THROW(refineBoundary(tube, 1000), InvalidInput);
}

} // namespace
