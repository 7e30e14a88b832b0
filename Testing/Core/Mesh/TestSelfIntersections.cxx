// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SelfIntersections.h"
#include "Support/AbandonedCall.h"
#include "Support/SampleSurfaces.h"

namespace
{

using namespace flattening;
using namespace flattening::samples;

// Two triangles with a common edge that lie beside each other, two that are folded onto each other, and
// one that goes through another.
TEST(SelfIntersections, CountsPairsThatShareMoreThanTheirCorners)
{
  const TriangleMesh mesh = meshOf({ { 0, 0, 0 },
                                     { 1, 0, 0 },
                                     { 0, 1, 0 },
                                     { 0, -1, 0 },
                                     { 1, 1, 0 },
                                     { 0.2, 0.2, -1 },
                                     { 0.3, 0.2, 1 },
                                     { 0.2, 0.3, 1 } },
    { { 0, 1, 2 }, { 1, 0, 3 } });
  EXPECT_EQ(countSelfIntersections(mesh), 0u);
  TriangleMesh folded = mesh;
  folded.Faces.row(1) << 1, 0, 4;
  EXPECT_EQ(countSelfIntersections(folded), 1u);
  TriangleMesh pierced = mesh;
  pierced.Faces.conservativeResize(3, 3);
  pierced.Faces.row(2) << 5, 6, 7;
  EXPECT_EQ(countSelfIntersections(pierced), 1u);
}

// A search waits for the end of an abandoned call, and reports meanwhile from the calling thread.
TEST(SelfIntersections, ReportsWhileItWaits)
{
  AbandonedCall abandoned;
  int reports = 0;
  const auto endAtTheThird = [&](double, const char*)
  {
    if (++reports == 3)
    {
      abandoned.end();
    }
    return true;
  };
  EXPECT_EQ(countSelfIntersections(both(sphere(1), moved(sphere(1), 5.0, 0.0, 0.0)), endAtTheThird), 0u);
  EXPECT_GE(reports, 3);
}

// Ten thousand copies of a face intersect in fifty million pairs.
TEST(SelfIntersections, EndsWhenItIsAborted)
{
  constexpr int copies = 10000;
  TriangleMesh mesh = meshOf({}, {});
  mesh.Vertices.resize(3 * copies, 3);
  mesh.Faces.resize(copies, 3);
  for (int f = 0; f < copies; ++f)
  {
    mesh.Vertices.middleRows(3 * f, 3) = tetrahedron().Vertices.topRows(3);
    mesh.Faces.row(f) << 3 * f, 3 * f + 1, 3 * f + 2;
  }
  int reports = 0;
  const auto abortLater = [&reports](double, const char*) { return ++reports < 3; };
  EXPECT_THROW(countSelfIntersections(mesh, abortLater), Cancelled);
  EXPECT_EQ(reports, 3);
}

// Joined corners leave such a face on both banks of a seam whose points are too close together for their
// coordinates to tell them apart.
TEST(SelfIntersections, AFaceThatHasAVertexTwiceIntersectsNothing)
{
  TriangleMesh mesh = sphere(2);
  const int faces = mesh.faceCount();
  mesh.Faces.conservativeResize(3 * faces, 3);
  for (int f = 0; f < faces; ++f)
  {
    const Eigen::RowVector3i face = mesh.Faces.row(f);
    mesh.Faces.row(faces + f) << face[0], face[1], face[0];
    mesh.Faces.row(2 * faces + f) << face[2], face[2], face[1];
  }
  EXPECT_EQ(countSelfIntersections(mesh), 0u);
}

} // namespace
