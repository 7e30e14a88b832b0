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

TEST(LongestEdgeBisection, NoEdgeOfTheGivenFacesStaysTooLong)
{
  const TriangleMesh mesh = sphere(2);
  const double longest = 0.4 * meanEdgeLength(mesh);
  EditableSurface surface(mesh);
  const auto faces = surface.mesh().faces();
  bisectLongEdges(surface, { faces.begin(), faces.end() }, longest);
  for (const EditableSurface::Face f : surface.mesh().faces())
  {
    EXPECT_LE(surface.longestEdge(f), longest * (1.0 + 1e-12));
  }
  // Bisection makes no edge shorter than half of what is allowed, but for the medians of flat faces.
  EXPECT_GT(meanEdgeLength(surface.derived().Mesh), 0.5 * longest);
}

// Bisecting all parts of the faces along the boundary would make a number of faces that grows with the
// square of the number of vertices.
TEST(LongestEdgeBisection, FacesGrowWithTheNumberOfBoundaryVertices)
{
  const TriangleMesh tube = cylinder(20, 6, 3.0);
  for (const int vertices : { 160, 320, 640, 1280, 2560 })
  {
    const DerivedMesh refined = refineBoundary(tube, vertices);
    EXPECT_LT(refined.Mesh.faceCount(), 11 * vertices);
  }
}

// Fourteen faces from a small loop to a far tip.
TEST(LongestEdgeBisection, FacesThatReachFarAreBisectedNearTheBoundaryOnly)
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
  EXPECT_EQ(loop.size(), 14u * 8u); // a side is 4.6 times as long as allowed and is halved three times
  EXPECT_LT(refined.Mesh.faceCount(), 5000);
  EXPECT_NEAR(loopLength(refined.Mesh.Vertices, loop), 28.0 * std::sin(Pi / 14.0), 1e-12);
  EXPECT_NEAR(totalArea(refined.Mesh), totalArea(needles), 1e-10);
  EXPECT_GE(smallestAngle(refined.Mesh), 0.5 * smallestAngle(needles));
  for (int f = 0; f < refined.Mesh.faceCount(); ++f) // no edge at the boundary is longer than asked for
  {
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d a = refined.Mesh.Vertices.row(refined.Mesh.Faces(f, k));
      const Eigen::Vector3d b = refined.Mesh.Vertices.row(refined.Mesh.Faces(f, (k + 1) % 3));
      EXPECT_TRUE((a - b).norm() <= 28.0 * std::sin(Pi / 14.0) / 64.0 || (a.z() > 0.0 && b.z() > 0.0));
    }
  }
}

TEST(LongestEdgeBisection, TooManyVerticesAreAnErrorThatNamesTheSetting)
{
  const std::string message =
    messageOf<InvalidInput>([] { refineBoundary(cylinder(20, 6, 3.0), 1000000); });
  EXPECT_TRUE(contains(message, "a million new points: lower Minimum Boundary Vertices")) << message;
}

// Needles around an apex that lies far off: the path over ever longer edges visits all of them before it
// ends, and each is halved some forty times. A path that began anew after every split took ten times as
// long.
TEST(LongestEdgeBisection, ManyNeedlesAreAnErrorToo)
{
  constexpr int count = 40000;
  TriangleMesh needles;
  needles.Vertices.resize(count + 1, 3);
  needles.Faces.resize(count, 3);
  for (int v = 0; v < count; ++v)
  {
    const double angle = 2.0 * Pi * v / count;
    needles.Vertices.row(v) << std::cos(angle), std::sin(angle), 1e-6 * v;
    needles.Faces.row(v) << v, (v + 1) % count, count;
  }
  needles.Vertices.row(count) << 1e9, 0.0, 0.0;
  const std::string message = messageOf<InvalidInput>([&] { refineBoundary(needles, 100000); });
  EXPECT_TRUE(contains(message, "remove points that lie far off")) << message;
}

// A tube of which one vertex, not at a boundary, lies far from the rest. With the far edges of length 1
// the squared lengths of the others are 0 in single precision. The number of new faces may not depend on
// it: bisected in another order than that of their lengths, the edges took a million new vertices.
TEST(LongestEdgeBisection, EdgesOfAnyLengthsAreInOrder)
{
  int expected = 0;
  for (const double distance : { 1e9, 1e12, 1e23, 1e30, 1e38 })
  {
    TriangleMesh tube = cylinder(20, 6, 3.0);
    tube.Vertices.row(65) << distance, 0.0, 0.0;
    tube.Vertices /= distance;
    const DerivedMesh refined = refineBoundary(tube, 128);
    expected = expected == 0 ? refined.Mesh.faceCount() : expected;
    EXPECT_EQ(refined.Mesh.faceCount(), expected) << distance;
    EXPECT_LT(refined.Mesh.faceCount(), 2500) << distance;
  }
}

TEST(LongestEdgeBisection, EndsWhereDoublePrecisionDoes)
{
  TriangleMesh tube = cylinder(20, 6, 3.0);
  tube.Vertices.col(0).array() += 1e14;
  EXPECT_THROW(refineBoundary(tube, 1000), InvalidInput);
}

} // namespace
