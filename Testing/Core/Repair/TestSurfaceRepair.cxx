// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Mesh/MeshTopology.h"
#include "Repair/ConsistentOrientation.h"
#include "Repair/SurfaceRepair.h"
#include "Repair/TJunctions.h"
#include "Support/SampleSurfaces.h"

#include <limits>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

MeshTopology topologyOf(const RepairedSurface& repaired)
{
  const TriangleMesh& mesh = repaired.Surface.Mesh;
  return analyseTopology(mesh.Faces, mesh.vertexCount());
}

// The largest distance of a vertex from where its origins are.
double traceError(const RepairedSurface& repaired, const TriangleMesh& input)
{
  return (repaired.Surface.Vertices * input.Vertices - repaired.Surface.Mesh.Vertices)
    .cwiseAbs()
    .maxCoeff();
}

TEST(SurfaceRepair, ACleanMeshStaysAsItIs)
{
  const TriangleMesh input = sphere(2);
  const RepairedSurface repaired = repairTriangleSoup(input);
  EXPECT_EQ(repaired.Surface.Mesh.Faces, input.Faces);
  EXPECT_EQ(repaired.Surface.Mesh.Vertices, input.Vertices);
  EXPECT_EQ(repaired.Report.MergedPoints, 0);
  EXPECT_EQ(repaired.Report.SplitPoints, 0);
  for (int f = 0; f < input.faceCount(); ++f)
  {
    EXPECT_EQ(repaired.Surface.Faces[f], f);
  }
}

TEST(SurfaceRepair, MergesTheCornersOfATriangleSoup)
{
  const TriangleMesh input = soupOf(sphere(2));
  const RepairedSurface repaired = repairTriangleSoup(input);
  const MeshTopology topology = topologyOf(repaired);
  EXPECT_EQ(topology.Vertices, 162);
  EXPECT_EQ(topology.Faces, 320);
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_TRUE(topology.BoundaryLoops.empty());
  EXPECT_EQ(repaired.Report.MergedPoints, 3 * 320 - 162);
  EXPECT_EQ(traceError(repaired, input), 0.0);
}

TEST(SurfaceRepair, MergesWithinTheTolerance)
{
  TriangleMesh input = soupOf(sphere(1));
  for (int v = 0; v < input.vertexCount(); ++v)
  {
    input.Vertices(v, v % 3) += 1e-4 * std::sin(37.0 * v);
  }
  EXPECT_EQ(topologyOf(repairTriangleSoup(input)).Components, 80);
  const RepairedSurface repaired = repairTriangleSoup(input, 1e-3);
  EXPECT_EQ(repaired.Report.MergedPoints, 3 * 80 - 42);
  EXPECT_EQ(topologyOf(repaired).Components, 1);
  EXPECT_TRUE(topologyOf(repaired).BoundaryLoops.empty());
}

TEST(SurfaceRepair, DropsDegenerateAndDuplicateFacesAndUnusedPoints)
{
  TriangleMesh input = sphere(1);
  const int faces = input.faceCount();
  input.Faces.conservativeResize(faces + 3, 3);
  input.Faces.row(faces) = input.Faces.row(5);
  input.Faces.row(faces + 1) << input.Faces(7, 1), input.Faces(7, 0), input.Faces(7, 2); // reversed
  input.Faces.row(faces + 2) << 3, 3, 8;
  input.Vertices.conservativeResize(input.vertexCount() + 2, 3);
  input.Vertices.bottomRows(2).setConstant(std::numeric_limits<double>::quiet_NaN()); // in no face
  const RepairedSurface repaired = repairTriangleSoup(input);
  EXPECT_EQ(repaired.Report.DuplicateFaces, 2);
  EXPECT_EQ(repaired.Report.DegenerateFaces, 1);
  EXPECT_EQ(repaired.Report.UnusedPoints, 2);
  EXPECT_EQ(topologyOf(repaired).Faces, faces);
  EXPECT_TRUE(topologyOf(repaired).BoundaryLoops.empty());
}

// A vertex lies in the middle of an edge of a tetrahedron on one side only; a cap joins the other side
// to it.
TEST(SurfaceRepair, ACapLeavesNoTJunction)
{
  const TriangleMesh input =
    meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.5, 0.5, 0 } },
      { { 0, 4, 1 }, { 0, 2, 4 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 }, { 1, 4, 2 } });
  const RepairedSurface repaired = repairTriangleSoup(input);
  EXPECT_EQ(repaired.Report.DegenerateFaces, 1);
  const MeshTopology topology = topologyOf(repaired);
  EXPECT_EQ(topology.Vertices, 5);
  EXPECT_EQ(topology.Faces, 6);
  EXPECT_TRUE(topology.BoundaryLoops.empty());
  EXPECT_NEAR(totalArea(repaired.Surface.Mesh), totalArea(tetrahedron()), 1e-15);
  EXPECT_EQ(std::count(repaired.Surface.Faces.begin(), repaired.Surface.Faces.end(), 4), 2);
}

TEST(SurfaceRepair, AChainOfCapsIsDissolved)
{
  // Only caps refine the edge (0,1) of the unit square, at 1/4, 1/2 and 3/4.
  const TriangleMesh input = meshOf(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { .25, 0, 0 }, { .5, 0, 0 }, { .75, 0, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 5, 1 }, { 0, 4, 5 }, { 5, 6, 1 } });
  const RepairedSurface repaired = repairTriangleSoup(input);
  EXPECT_EQ(repaired.Report.DegenerateFaces, 3);
  const MeshTopology topology = topologyOf(repaired);
  EXPECT_EQ(topology.Components, 1);
  ASSERT_EQ(topology.BoundaryLoops.size(), 1u);
  EXPECT_EQ(topology.BoundaryLoops[0].size(), 7u);
  EXPECT_DOUBLE_EQ(totalArea(repaired.Surface.Mesh), 1.0);
  EXPECT_GT(faceAreas(repaired.Surface.Mesh.Vertices, repaired.Surface.Mesh.Faces).minCoeff(), 0.1);
}

// The lower half of the square uses copies of its corners that are 1e-12 of its side away.
TEST(SurfaceRepair, NeedlesAreCollapsed)
{
  const double tiny = 1e-12;
  const TriangleMesh input =
    meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 1, 1 + tiny, 0 }, { tiny, 0, 0 } },
      { { 0, 4, 3 }, { 0, 2, 4 }, { 0, 5, 2 }, { 5, 1, 2 } });
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    TriangleMesh scaled = input;
    scaled.Vertices *= scale;
    const RepairedSurface repaired = repairTriangleSoup(scaled);
    EXPECT_EQ(repaired.Report.MergedPoints, 2);
    EXPECT_EQ(repaired.Report.DegenerateFaces, 2);
    EXPECT_EQ(repaired.Surface.Faces, (std::vector<int>{ 0, 3 }));
    const MeshTopology topology = topologyOf(repaired);
    EXPECT_EQ(topology.Vertices, 4);
    EXPECT_EQ(topology.Edges, 5);
    EXPECT_EQ(totalArea(repaired.Surface.Mesh), scale * scale);
    EXPECT_EQ(traceError(repaired, scaled), 0.0);
  }
  // A hundred times the bound is a triangle like any other.
  TriangleMesh thin = input;
  thin.Vertices(4, 1) = 1.0 + 1e-7;
  thin.Vertices(5, 0) = 1e-7;
  EXPECT_EQ(repairTriangleSoup(thin).Report.DegenerateFaces, 0);
}

// Two edges of a unit square's upper half are refined on their other sides only: the diagonal at 1/4,
// 1/2 and 3/4, the right side in the middle. No caps close the T-junctions.
TEST(SurfaceRepair, ClosesTJunctions)
{
  const TriangleMesh input = meshOf({ { 0, 0, 0 },
                                      { 1, 0, 0 },
                                      { 1, 1, 0 },
                                      { 0, 1, 0 },
                                      { .25, .25, 0 },
                                      { .5, .5, 0 },
                                      { .75, .75, 0 },
                                      { 2, .5, 0 },
                                      { 1, .5, 0 } },
    { { 0, 2, 3 }, { 1, 4, 0 }, { 5, 4, 1 }, { 6, 5, 1 }, { 2, 6, 1 }, { 1, 7, 8 }, { 8, 7, 2 } });
  for (const double distance : { 0.0, 1e-13, 1e-8 })
  {
    TriangleMesh moved = input;
    moved.Vertices(5, 1) += distance;
    const RepairedSurface repaired = repairTriangleSoup(moved, distance > 1e-10 ? 1e-6 : 0.0);
    EXPECT_EQ(repaired.Report.ClosedTJunctions, 4);
    const MeshTopology topology = topologyOf(repaired);
    EXPECT_EQ(topology.Components, 1);
    EXPECT_EQ(topology.Vertices, 9);
    EXPECT_EQ(topology.Faces, 11);
    ASSERT_EQ(topology.BoundaryLoops.size(), 1u);
    EXPECT_EQ(topology.BoundaryLoops[0].size(), 5u);
    EXPECT_NEAR(totalArea(repaired.Surface.Mesh), 1.5, 2.0 * distance + 1e-15);
    EXPECT_EQ(std::count(repaired.Surface.Faces.begin(), repaired.Surface.Faces.end(), 0), 4);
    EXPECT_EQ(std::count(repaired.Surface.Faces.begin(), repaired.Surface.Faces.end(), 4), 2);
  }
  // A gap wider than the tolerance stays a hole.
  TriangleMesh wide = input;
  wide.Vertices(5, 1) += 1e-8;
  EXPECT_EQ(repairTriangleSoup(wide).Report.ClosedTJunctions, 3);
  EXPECT_EQ(topologyOf(repairTriangleSoup(wide)).BoundaryLoops.size(), 2u);
}

// A vertex near a corner lies on both edges at the corner, as far as the tolerance tells. The part of
// the face between the vertex and the corner has no area left.
TEST(SurfaceRepair, ClosesTwoTJunctionsOfOneVertex)
{
  const TriangleMesh input =
    meshOf({ { -1, 0, 0 }, { 0, 0, 0 }, { -.8, .5, 0 }, { -.08, 0, 0 }, { -.5, -1, 0 } },
      { { 0, 1, 2 }, { 0, 4, 3 }, { 3, 4, 1 } });
  const RepairedSurface repaired = repairTriangleSoup(input, 0.05);
  EXPECT_EQ(repaired.Report.ClosedTJunctions, 2);
  const MeshTopology topology = topologyOf(repaired);
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Vertices, 5);
  EXPECT_EQ(topology.Faces, 3);
  ASSERT_EQ(topology.BoundaryLoops.size(), 1u);
  EXPECT_EQ(topology.BoundaryLoops[0].size(), 5u);
}

// A point without coordinates must not stand between equal points while these are sorted.
TEST(SurfaceRepair, MergesPointsAmongSomeThatAreNotFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TriangleMesh input = meshOf({ { 2, 0, 0 },
                                      { nan, nan, nan },
                                      { 1, 0, 0 },
                                      { 2, 0, 0 },
                                      { nan, 0, 0 },
                                      { 1, 1, 0 },
                                      { 3, 1, 0 } },
    { { 0, 5, 2 }, { 3, 6, 5 } });
  for (const double tolerance : { 0.0, 1e-3 })
  {
    const RepairedSurface repaired = repairTriangleSoup(input, tolerance);
    EXPECT_EQ(repaired.Report.MergedPoints, 1);
    EXPECT_EQ(topologyOf(repaired).Components, 1);
    EXPECT_EQ(topologyOf(repaired).Vertices, 4);
  }
}

// A vertex beside a sliver is within the tolerance of two of its edges and farther from them than the
// sliver is high: parts that ended at the vertex would lie over each other.
TEST(SurfaceRepair, DoesNotFoldASliverToCloseATJunction)
{
  const TriangleMesh input =
    meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { .5, .005, 0 }, { .25, .008, 0 }, { .35, 1, 0 }, { .25, 1, 0 } },
      { { 0, 1, 2 }, { 3, 4, 5 } });
  FaceList list{ { { 0, 1, 2 }, { 3, 4, 5 } }, { 0, 1 } };
  EXPECT_EQ(closeTJunctions(input.Vertices, list, 0.01), 0);
  EXPECT_EQ(list.Faces, (std::vector<Triangle>{ { 0, 1, 2 }, { 3, 4, 5 } }));
  // Over a face of ordinary height the same vertex is on the edge.
  TriangleMesh high = input;
  high.Vertices(2, 1) = 0.5;
  EXPECT_EQ(closeTJunctions(high.Vertices, list, 0.01), 1);
  EXPECT_EQ(list.Faces.size(), 3u);
}

TEST(SurfaceRepair, SeparatesWhatTouchesInAVertexOrAnEdge)
{
  // Mirrored tetrahedra share the vertex at the origin.
  TriangleMesh mirrored = tetrahedron();
  mirrored.Vertices *= -1.0;
  const RepairedSurface vertex = repairTriangleSoup(both(tetrahedron(), mirrored));
  EXPECT_EQ(vertex.Report.MergedPoints, 1);
  EXPECT_EQ(vertex.Report.SplitPoints, 1);
  EXPECT_EQ(topologyOf(vertex).Components, 2);
  EXPECT_TRUE(topologyOf(vertex).BoundaryLoops.empty());

  // Rotated by half a turn about the x axis they share the edge (0, 1).
  TriangleMesh turned = tetrahedron();
  turned.Vertices.rightCols(2) *= -1.0;
  const RepairedSurface edge = repairTriangleSoup(both(tetrahedron(), turned));
  EXPECT_EQ(edge.Report.MergedPoints, 2);
  EXPECT_EQ(edge.Report.SplitPoints, 2);
  EXPECT_EQ(topologyOf(edge).Components, 2);
  EXPECT_TRUE(topologyOf(edge).BoundaryLoops.empty());
}

TEST(SurfaceRepair, CopiesOnlyTheVerticesInWhichFansMeet)
{
  // A tetrahedron stands on vertex 11 of a grid of 5 x 5 vertices, another one on vertex 13. Vertex 12,
  // between them, has faces beside the one and beside the other, but also faces in between.
  TriangleMesh surface = rectangleGrid(5, 5, 1.0);
  for (const int touched : { 11, 13 })
  {
    TriangleMesh standing = tetrahedron();
    standing.Vertices *= 0.01;
    standing.Vertices.rowwise() += surface.Vertices.row(touched);
    surface = both(surface, standing);
  }
  const RepairedSurface repaired = repairTriangleSoup(surface);
  EXPECT_EQ(repaired.Report.MergedPoints, 2);
  EXPECT_EQ(repaired.Report.SplitPoints, 2);
  EXPECT_EQ(topologyOf(repaired).Components, 3);
  EXPECT_EQ(topologyOf(repaired).BoundaryLoops.size(), 1u);
  EXPECT_EQ(repaired.Surface.Mesh.vertexCount(), surface.vertexCount());
  EXPECT_EQ(traceError(repaired, surface), 0.0);
}

TEST(SurfaceRepair, AFinOnASphereComesOffWhole)
{
  TriangleMesh input = sphere(1);
  const int tip = input.vertexCount();
  input.Vertices.conservativeResize(tip + 1, 3);
  input.Vertices.row(tip) << 3, 3, 3;
  input.Faces.conservativeResize(input.faceCount() + 1, 3);
  input.Faces.bottomRows(1) << input.Faces(0, 0), input.Faces(0, 1), tip;
  const MeshTopology topology = topologyOf(repairTriangleSoup(input));
  EXPECT_EQ(topology.Components, 2);
  ASSERT_EQ(topology.BoundaryLoops.size(), 1u); // the boundary of the fin; the sphere is closed again
  EXPECT_EQ(topology.BoundaryLoops[0].size(), 3u);
}

TEST(SurfaceRepair, OrientsNeighboursAlikeAndClosedSurfacesOutward)
{
  const TriangleMesh straight = sphere(2);
  TriangleMesh input = straight;
  int turned = 0;
  for (int f = 0; f < input.faceCount(); f += 3, ++turned)
  {
    std::swap(input.Faces(f, 1), input.Faces(f, 2));
  }
  RepairedSurface repaired = repairTriangleSoup(input);
  TriangleMesh& mesh = repaired.Surface.Mesh;
  EXPECT_EQ(orientOutward(mesh, repaired.Reversed, true), turned);
  EXPECT_NEAR(enclosedVolume(mesh), enclosedVolume(straight), 1e-12);
}

TEST(SurfaceRepair, AnOpenSurfaceKeepsTheSideOfTheLargerArea)
{
  TriangleMesh input = cylinder(16, 6, 2.0);
  for (const int f : { 0, 1, 2, 50 }) // the first face too, which orientation starts from
  {
    std::swap(input.Faces(f, 1), input.Faces(f, 2));
  }
  RepairedSurface repaired = repairTriangleSoup(input);
  EXPECT_EQ(orientOutward(repaired.Surface.Mesh, repaired.Reversed, false), 4);
  const TriangleMesh& mesh = repaired.Surface.Mesh;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const Eigen::Vector3d a = mesh.Vertices.row(mesh.Faces(f, 0));
    const Eigen::Vector3d b = mesh.Vertices.row(mesh.Faces(f, 1));
    const Eigen::Vector3d c = mesh.Vertices.row(mesh.Faces(f, 2));
    EXPECT_GT((b - a).cross(c - a).dot(Eigen::Vector3d(a.x(), a.y(), 0)), 0.0) << f;
  }
}

TEST(SurfaceRepair, MarksTheCutOfAMoebiusStrip)
{
  const RepairedSurface repaired = repairTriangleSoup(moebiusStrip(12));
  EXPECT_EQ(repaired.Report.SplitPoints, 2);
  EXPECT_EQ(std::count(repaired.OneSided.begin(), repaired.OneSided.end(), 1), 2);
  // An orientable band of the same kind has none.
  const RepairedSurface band = repairTriangleSoup(cylinder(12, 1, 1.0));
  EXPECT_EQ(std::count(band.OneSided.begin(), band.OneSided.end(), 1), 0);
}

TEST(SurfaceRepair, NamesWhatCannotBeUsed)
{
  TriangleMesh input = sphere(0);
  input.Faces.conservativeResize(0, 3);
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { repairTriangleSoup(input); }), "no triangles"));

  input = sphere(0);
  input.Vertices(5, 1) = std::numeric_limits<double>::infinity();
  const std::string message = messageOf<InvalidInput>([&] { repairTriangleSoup(input); });
  EXPECT_TRUE(contains(message, "point 5") && contains(message, "not finite")) << message;

  input = sphere(0);
  input.Vertices.rightCols(2).setZero();
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { repairTriangleSoup(input); }), "zero area"));

  input = sphere(0);
  input.Faces(3, 1) = 99;
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { repairTriangleSoup(input); }), "vertex 99"));
}

} // namespace
