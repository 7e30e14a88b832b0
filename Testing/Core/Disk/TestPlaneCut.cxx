// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Disk/PlaneCut.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/BoundaryRefinement.h"
#include "Repair/HoleFilling.h"
#include "Support/SampleSurfaces.h"

#include <algorithm>

namespace
{

using namespace flattening;
using namespace flattening::samples;

CuttingPlane plane(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal)
{
  return { origin, normal };
}

double smallestAngle(const TriangleMesh& mesh)
{
  double smallest = 180.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d a = mesh.Vertices.row(mesh.Faces(f, k));
      const Eigen::Vector3d u = mesh.Vertices.row(mesh.Faces(f, (k + 1) % 3)).transpose() - a;
      const Eigen::Vector3d v = mesh.Vertices.row(mesh.Faces(f, (k + 2) % 3)).transpose() - a;
      smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / Pi);
    }
  }
  return smallest;
}

TEST(PlaneCut, OfASphereIsTheSphericalCap)
{
  const TriangleMesh closed = sphere(6);
  const Eigen::Vector3d directions[] = { { 0, 0, 1 }, { 0, 0, -7 }, { 0.3, -0.5, 0.4 } };
  for (const Eigen::Vector3d& direction : directions)
  {
    const Eigen::Vector3d normal = direction.normalized();
    // At 0 the plane goes through vertices and along edges.
    for (const double h : { 0.0, 0.3, -0.5, 0.9 })
    {
      const PlaneCutSurface cut = cutAtPlane(closed, plane(h * normal, direction));
      const TriangleMesh& mesh = cut.Surface.Mesh;
      const std::vector<int> boundary = requireDisk(mesh);
      // Chords and flat faces fall short of the sphere by 1e-4.
      EXPECT_NEAR(totalArea(mesh), 2.0 * Pi * (1.0 - h), 1e-3);
      EXPECT_NEAR(cut.RemovedArea, 2.0 * Pi * (1.0 + h), 1e-3);
      EXPECT_NEAR(totalArea(mesh) + cut.RemovedArea, totalArea(closed), 1e-4);
      EXPECT_NEAR(loopLength(mesh.Vertices, boundary), 2.0 * Pi * std::sqrt(1.0 - h * h), 2e-3);
      EXPECT_GE(boundary.size(), 128u);
      for (const int v : boundary)
      {
        EXPECT_NEAR(normal.dot(mesh.Vertices.row(v)), h, 1e-14);
      }
      EXPECT_GE((mesh.Vertices * normal).minCoeff(), h - 1e-14);
      EXPECT_GT(smallestAngle(mesh), 8.0);
      EXPECT_LT((cut.Surface.Vertices * closed.Vertices - mesh.Vertices).cwiseAbs().maxCoeff(), 1e-13);
    }
  }
}

TEST(PlaneCut, KeepsAllPartsAndOlderBoundaries)
{
  // Half of a tube standing on the plane's edge: the cut ends at both rims, which stay.
  const TriangleMesh tube = cylinder(60, 20, 3.0);
  const PlaneCutSurface half = cutAtPlane(tube, plane({ 0.001, 0, 0 }, { 1, 0, 0 }), 3);
  EXPECT_NEAR(totalArea(half.Surface.Mesh), 0.5 * totalArea(tube), 0.01 * totalArea(tube));
  requireDisk(half.Surface.Mesh);
  int onRims = 0;
  for (int v = 0; v < half.Surface.Mesh.vertexCount(); ++v)
  {
    const double z = half.Surface.Mesh.Vertices(v, 2);
    onRims += z == 0.0 || z == 3.0 ? 1 : 0;
  }
  int before = 0;
  for (int v = 0; v < tube.vertexCount(); ++v)
  {
    before += tube.Vertices(v, 0) > 0.001 && (v < 60 || v >= 1200) ? 1 : 0;
  }
  EXPECT_EQ(onRims, before + 4); // the four ends of the cut

  // Half of a torus is a tube; a torus without a cap at its side still has its handle.
  const TriangleMesh ring = torus(80, 30);
  const PlaneCutSurface bow = cutAtPlane(ring, plane({ 0.1, 0, 0 }, { 1, 0, 0 }));
  MeshTopology topology = analyseTopology(bow.Surface.Mesh.Faces, bow.Surface.Mesh.vertexCount());
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_EQ(topology.BoundaryLoops.size(), 2u);
  const PlaneCutSurface most = cutAtPlane(ring, plane({ -2.3, 0, 0 }, { 1, 0, 0 }));
  topology = analyseTopology(most.Surface.Mesh.Faces, most.Surface.Mesh.vertexCount());
  EXPECT_EQ(topology.Genus, 1);
  EXPECT_EQ(topology.BoundaryLoops.size(), 1u);
  const PlaneCutSurface both =
    cutAtPlane(samples::both(sphere(3), moved(sphere(3), 3, 0, 0)), plane({ 0, 0, 0.2 }, { 0, 0, 1 }));
  EXPECT_EQ(analyseTopology(both.Surface.Mesh.Faces, both.Surface.Mesh.vertexCount()).Components, 2);
}

TEST(PlaneCut, ResolvesTheBoundaryOfTheCoarsestMeshes)
{
  for (const TriangleMesh& closed : { tetrahedron(), icosahedron() })
  {
    const Eigen::Vector3d centre = closed.Vertices.colwise().mean();
    const PlaneCutSurface cut = cutAtPlane(closed, plane(centre, { 1, 2, 3 }));
    const std::vector<int> boundary = requireDisk(cut.Surface.Mesh);
    EXPECT_GE(boundary.size(), 128u);
    EXPECT_LT(cut.Surface.Mesh.vertexCount(), 10000);
    EXPECT_NEAR(
      totalArea(cut.Surface.Mesh) + cut.RemovedArea, totalArea(closed), 1e-4 * totalArea(closed));
  }
}

TEST(PlaneCut, DoesNotDependOnTheUnit)
{
  const TriangleMesh closed = sphere(4);
  const PlaneCutSurface cut = cutAtPlane(closed, plane({ 0, 0, 0.25 }, { 0, 1, 1 }));
  for (const double scale : { std::ldexp(1.0, -30), 1.0, std::ldexp(1.0, 30) })
  {
    TriangleMesh scaled = closed;
    scaled.Vertices *= scale;
    const PlaneCutSurface other =
      cutAtPlane(scaled, plane({ 0, 0, 0.25 * scale }, { 0, 1 / scale, 1 / scale }));
    EXPECT_EQ(other.Surface.Mesh.Faces, cut.Surface.Mesh.Faces);
    EXPECT_EQ(other.Surface.Mesh.Vertices, (scale * cut.Surface.Mesh.Vertices).eval());
  }
}

TEST(PlaneCut, RefusesAPlaneThatMisses)
{
  const TriangleMesh closed = sphere(2);
  EXPECT_TRUE(contains(messageOf<InvalidInput>(
                         [&] {
                           cutAtPlane(closed, plane({ 0, 0, 2 }, { 0, 0, 1 }));
                         }),
    "removed"));
  EXPECT_TRUE(contains(messageOf<InvalidInput>(
                         [&] {
                           cutAtPlane(closed, plane({ 0, 0, 2 }, { 0, 0, -1 }));
                         }),
    "kept"));
  EXPECT_TRUE(contains(messageOf<InvalidInput>(
                         [&] {
                           cutAtPlane(closed, plane({ 0, 0, 0 }, { 0, 0, 0 }));
                         }),
    "zero"));
  EXPECT_TRUE(contains(messageOf<InvalidInput>(
                         [&] {
                           cutAtPlane(closed, plane({ NAN, 0, 0 }, { 0, 0, 1 }));
                         }),
    "not finite"));
  EXPECT_THROW(
    cutAtPlane(closed, plane({ 0, 0, 0 }, { 0, 0, 1 }), 128, [](double, const char*) { return false; }),
    Cancelled);
}

TEST(BoundaryRefinement, AddsVerticesToTheLongestLoopAlone)
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

} // namespace
