// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Disk/PlaneCut.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Repair/HoleFilling.h"
#include "Support/SampleSurfaces.h"

#include <algorithm>
#include <cstdio>

namespace
{

using namespace flattening;
using namespace flattening::samples;

CuttingPlane plane(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal)
{
  return { origin, normal };
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

// A thin ring of slivers that lie side by side across the plane: halving them makes ever more
// that the plane crosses.
TEST(PlaneCut, OfLongSliversEndsSoon)
{
  TriangleMesh ring = torus(3, 14);
  for (int v = 0; v < ring.vertexCount(); ++v)
  {
    const double radius = ring.Vertices.row(v).head(2).norm();
    ring.Vertices.row(v).head(2) *= (2.0 + 1e-3 * (radius - 2.0)) / radius;
    ring.Vertices(v, 2) *= 1e-3;
  }
  const PlaneCutSurface cut = cutAtPlane(ring, plane({ 0, 0, 0 }, { 1, 0, 0 }), 256);
  std::printf("slivers: %d faces of %d\n", cut.Surface.Mesh.faceCount(), ring.faceCount());
  EXPECT_LT(cut.Surface.Mesh.faceCount(), 20000);
  EXPECT_GE(
    analyseTopology(cut.Surface.Mesh.Faces, cut.Surface.Mesh.vertexCount()).BoundaryLoops.size(), 1u);
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

TEST(PlaneCut, RejectsAPlaneThatMisses)
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

// A plane through a corner, an edge or a face that cuts off no more than rounding, or a cut whose
// vertices double precision would not hold apart.
TEST(PlaneCut, RejectsAPlaneThatTouches)
{
  TriangleMesh corner = tetrahedron();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  corner.Vertices = (corner.Vertices * turn.transpose()).eval();
  const auto rejection = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
  { return messageOf<InvalidInput>([&] { cutAtPlane(corner, plane(turn * point, turn * normal)); }); };
  for (const double depth : { 0.0, 1e-16, 1e-15, 1e-14 })
  {
    for (const double sign : { 1.0, -1.0 })
    {
      for (const Eigen::Vector3d& normal :
        { Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0, 0, 1) })
      {
        const std::string message = rejection(depth * normal.normalized(), sign * normal);
        EXPECT_TRUE(contains(message, "misses the surface or only touches it") &&
                    contains(message, sign > 0.0 ? "be kept" : "be removed") &&
                    contains(message, "; move the plane's origin into the surface") &&
                    !contains(message, "turn"))
          << message;
      }
    }
  }
  // The cut is an equilateral triangle with a circumference of 3 sqrt(6) depths.
  const std::string message =
    rejection(1e-13 * Eigen::Vector3d(1, 1, 1).normalized(), Eigen::Vector3d(1, 1, 1));
  EXPECT_TRUE(contains(message, "only grazes the surface, along a curve of length 7.3")) << message;
  const PlaneCutSurface cut = cutAtPlane(
    corner, plane(turn * Eigen::Vector3d::Constant(1e-12), turn * Eigen::Vector3d(-1, -1, -1)));
  EXPECT_GE(requireDisk(cut.Surface.Mesh).size(), 128u);
}

} // namespace
