// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Disk/GeodesicHole.h"
#include "Disk/HolePlacement.h"
#include "Geodesics/GeodesicDistance.h"
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

// Heat vanishes on a way of so many edges.
TEST(GeodesicDistance, ReachesTheFarEndOfALongStrip)
{
  TriangleMesh strip = rectangleGrid(2000, 3, 2000.0);
  strip.Vertices.col(1) *= 1000.0;
  const Eigen::VectorXd distance = geodesicDistances(strip, 0);
  for (int v = 0; v < strip.vertexCount(); ++v)
  {
    const double expected = (strip.Vertices.row(v) - strip.Vertices.row(0)).norm();
    ASSERT_NEAR(distance[v], expected, 0.01 * expected + 2.0) << v;
  }
}

GeodesicHoleOptions holeAt(double x, double y, double z, double areaFraction = 1e-3)
{
  GeodesicHoleOptions options;
  options.Centre = Eigen::Vector3d(x, y, z);
  options.AreaFraction = areaFraction;
  return options;
}

double smallestAngleAtBoundary(const TriangleMesh& mesh, const std::vector<int>& boundary)
{
  const std::set<int> onBoundary(boundary.begin(), boundary.end());
  double smallest = 180.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    if (!onBoundary.count(mesh.Faces(f, 0)) && !onBoundary.count(mesh.Faces(f, 1)) &&
        !onBoundary.count(mesh.Faces(f, 2)))
    {
      continue;
    }
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

// 4 pi A / L^2: 1 for a flat disk, 2 pi / angle for a disk around the tip of a cone of that total angle.
double roundness(const OpenedSurface& opened)
{
  const auto boundary = requireDisk(opened.Surface.Mesh);
  const double length = loopLength(opened.Surface.Mesh.Vertices, boundary);
  return 4.0 * Pi * opened.RemovedArea / (length * length);
}

// The circle around the hole reaches around the needle, so that it is much shorter than the faces that
// it crosses.
TEST(GeodesicHole, InANeedleEndsSoon)
{
  TriangleMesh needle = sphere(1);
  needle.Vertices.col(0) *= 1e3;
  const OpenedSurface opened = cutGeodesicHole(needle, holeAt(1e3, 0.0, 0.0, 1e-2));
  std::printf("needle: %d faces of %d\n", opened.Surface.Mesh.faceCount(), needle.faceCount());
  EXPECT_LT(opened.Surface.Mesh.faceCount(), 20000);
  requireDisk(opened.Surface.Mesh);
}

TEST(GeodesicHole, OfASphereIsTheSphericalCap)
{
  const TriangleMesh closed = sphere(5);
  for (const double fraction : { 1e-4, 1e-3, 1e-2, 0.25 })
  {
    const OpenedSurface opened = cutGeodesicHole(closed, holeAt(0.3, -0.5, 0.8, fraction));
    const TriangleMesh& mesh = opened.Surface.Mesh;
    const std::vector<int> boundary = requireDisk(mesh);
    EXPECT_GE(boundary.size(), 128u);
    EXPECT_NEAR(opened.RemovedArea, fraction * totalArea(closed), 1e-9 * fraction);
    // Conditioning moves vertices within the boundary's triangles only.
    EXPECT_NEAR(totalArea(mesh) + opened.RemovedArea, totalArea(closed), 2e-3 * opened.RemovedArea);

    const double radius = std::acos(1.0 - 2.0 * fraction);
    EXPECT_NEAR(opened.Radius, radius, 0.02 * radius);
    EXPECT_NEAR(loopLength(mesh.Vertices, boundary), 2.0 * Pi * std::sin(radius), 0.01 * radius);
    const Eigen::Vector3d centre = opened.Centre.normalized();
    for (const int v : boundary)
    {
      const Eigen::Vector3d x = mesh.Vertices.row(v).normalized();
      EXPECT_NEAR(std::acos(x.dot(centre)), radius, 0.06 * radius);
    }
    EXPECT_GT(smallestAngleAtBoundary(mesh, boundary), 8.0);
  }
}

TEST(GeodesicHole, IsCentredAtThePointAskedFor)
{
  const OpenedSurface opened = cutGeodesicHole(sphere(4), holeAt(0, 0, 1.1));
  EXPECT_NEAR(opened.Centre.x(), 0.0, 1e-12);
  EXPECT_NEAR(opened.Centre.y(), 0.0, 1e-12);
  Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
  const auto boundary = requireDisk(opened.Surface.Mesh);
  for (const int v : boundary)
  {
    mean += opened.Surface.Mesh.Vertices.row(v) / static_cast<double>(boundary.size());
  }
  EXPECT_LT(mean.head<2>().norm(), 0.1 * opened.Radius);
}

TEST(GeodesicHole, IsRoundOnTheCoarsestMeshes)
{
  // Holes inside a face, on an edge, at a vertex with five triangles, and at one with three right
  // angles.
  const OpenedSurface face = cutGeodesicHole(tetrahedron(), holeAt(0.3, 0.2, -0.05));
  const OpenedSurface edge = cutGeodesicHole(tetrahedron(), holeAt(0.5, 0.0, 0.0));
  const OpenedSurface five = cutGeodesicHole(icosahedron());
  const OpenedSurface corner = cutGeodesicHole(tetrahedron(), holeAt(0.0, 0.0, 0.0));
  EXPECT_NEAR(roundness(face), 1.0, 0.01);
  EXPECT_NEAR(roundness(edge), 1.0, 0.01);
  EXPECT_NEAR(roundness(five), 6.0 / 5.0, 0.012);
  EXPECT_NEAR(roundness(corner), 4.0 / 3.0, 0.013);
  for (const OpenedSurface* opened : { &face, &edge, &five, &corner })
  {
    const auto boundary = requireDisk(opened->Surface.Mesh);
    EXPECT_GE(boundary.size(), 128u);
    EXPECT_LE(boundary.size(), 512u);
    EXPECT_GT(smallestAngleAtBoundary(opened->Surface.Mesh, boundary), 3.0);
    EXPECT_LT(opened->Surface.Mesh.vertexCount(), 10000);
  }
}

TEST(GeodesicHole, BoundaryHasAsManyVerticesAsAskedFor)
{
  for (const int wanted : { 128, 300, 1000 })
  {
    GeodesicHoleOptions options;
    options.BoundaryVertices = wanted;
    const TriangleMesh mesh = cutGeodesicHole(icosahedron(), options).Surface.Mesh;
    const auto vertices = static_cast<int>(requireDisk(mesh).size());
    EXPECT_GE(vertices, wanted);
    EXPECT_LE(vertices, 3 * wanted);
    EXPECT_LT(mesh.vertexCount(), 40 * wanted); // refined near the curve only
  }
}

TEST(GeodesicHole, TracesEveryVertexAndFace)
{
  const TriangleMesh closed = icosahedron();
  const OpenedSurface opened = cutGeodesicHole(closed);
  const DerivedMesh& surface = opened.Surface;
  EXPECT_LT((surface.Vertices * closed.Vertices - surface.Mesh.Vertices).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT(
    (surface.Vertices * Eigen::VectorXd::Ones(12) - Eigen::VectorXd::Ones(surface.Mesh.vertexCount()))
      .cwiseAbs()
      .maxCoeff(),
    1e-14);
  for (int f = 0; f < surface.Mesh.faceCount(); ++f)
  {
    std::set<int> corners;
    ASSERT_GE(surface.Faces[f], 0);
    for (int k = 0; k < 3; ++k)
    {
      corners.insert(closed.Faces(surface.Faces[f], k));
    }
    // Only the collapse of short edges may carry a corner of a face over an edge of the icosahedron.
    int foreign = 0;
    for (int k = 0; k < 3; ++k)
    {
      for (VertexOrigins::InnerIterator weight(surface.Vertices, surface.Mesh.Faces(f, k)); weight;
           ++weight)
      {
        foreign += !corners.count(weight.col()) && weight.value() > 0.02;
      }
    }
    EXPECT_EQ(foreign, 0) << f;
  }
}

// A power of two scales without rounding, so every decision must be the same.
TEST(GeodesicHole, DoesNotDependOnTheUnit)
{
  const TriangleMesh closed = sphere(3);
  const OpenedSurface opened = cutGeodesicHole(closed);
  for (const double scale : { std::ldexp(1.0, -30), std::ldexp(1.0, 30) })
  {
    TriangleMesh scaled = closed;
    scaled.Vertices *= scale;
    const OpenedSurface other = cutGeodesicHole(scaled);
    EXPECT_EQ(other.Surface.Mesh.Faces, opened.Surface.Mesh.Faces);
    EXPECT_EQ(other.Surface.Mesh.Vertices, (scale * opened.Surface.Mesh.Vertices).eval());
    EXPECT_EQ(other.Radius, scale * opened.Radius);
  }
}

TEST(GeodesicHole, IsPlacedOnTheSideOfALongShape)
{
  TriangleMesh cigar = sphere(4);
  cigar.Vertices.col(2) *= 5.0;
  const int centre = geodesicCentre(cigar);
  EXPECT_LT(std::abs(cigar.Vertices(centre, 2)), 0.75);
  EXPECT_EQ(geodesicCentre(cigar), centre);
}

// The best places on a long shape are around its waist; here the hole must avoid one side of it.
TEST(GeodesicHole, KeepsOffARegion)
{
  TriangleMesh cigar = sphere(4);
  cigar.Vertices.col(2) *= 5.0;
  GeodesicHoleOptions options;
  options.AreaFraction = 0.01;
  options.Avoided.resize(cigar.vertexCount());
  for (int v = 0; v < cigar.vertexCount(); ++v)
  {
    options.Avoided[v] = cigar.Vertices(v, 2) < 1.0;
  }
  const OpenedSurface opened = cutGeodesicHole(cigar, options);
  EXPECT_EQ(opened.RemovedAvoided, 0);
  double lowest = 5.0;
  for (const int v : requireDisk(opened.Surface.Mesh))
  {
    lowest = std::min(lowest, opened.Surface.Mesh.Vertices(v, 2));
  }
  EXPECT_GT(lowest, 1.0);
  // The hole is as near to the waist as the region allows.
  EXPECT_LT(opened.Centre.z(), 1.0 + 4.0 * opened.Radius);
  options.Avoided.assign(cigar.vertexCount(), 0);
  EXPECT_EQ(cutGeodesicHole(cigar, options).Centre,
    cutGeodesicHole(cigar,
      []
      {
        GeodesicHoleOptions anywhere;
        anywhere.AreaFraction = 0.01;
        return anywhere;
      }())
      .Centre);

  // If the region leaves too little room, the hole is as far from it as possible, and the report counts
  // the vertices of the region that it takes.
  for (int v = 0; v < cigar.vertexCount(); ++v)
  {
    options.Avoided[v] = cigar.Vertices(v, 2) < 4.9;
  }
  const OpenedSurface tip = cutGeodesicHole(cigar, options);
  EXPECT_GT(tip.Centre.z(), 4.9);
  EXPECT_GT(tip.RemovedAvoided, 0);

  options.Avoided.assign(cigar.vertexCount(), 1);
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { cutGeodesicHole(cigar, options); }), "covers all"));
  options.Avoided.resize(5);
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { cutGeodesicHole(cigar, options); }), "5 flags"));
}

TEST(GeodesicHole, LeavesHandlesAsTheyAre)
{
  const TriangleMesh ring = torus(60, 24);
  const OpenedSurface opened = cutGeodesicHole(ring, holeAt(0, 2.5, 0, 0.01));
  EXPECT_LT((opened.Centre - Eigen::Vector3d(0, 2.5, 0)).norm(), 0.05);
  EXPECT_NEAR(opened.RemovedArea, 0.01 * totalArea(ring), 1e-5 * totalArea(ring));
  const TriangleMesh& rest = opened.Surface.Mesh;
  const MeshTopology topology = analyseTopology(rest.Faces, rest.vertexCount());
  EXPECT_EQ(topology.Genus, 1);
  ASSERT_EQ(topology.BoundaryLoops.size(), 1u);
  EXPECT_GE(topology.BoundaryLoops[0].size(), 128u);
}

TEST(GeodesicHole, RejectsHolesThatCannotBeCut)
{
  EXPECT_TRUE(contains(
    messageOf<TopologyError>([] { cutGeodesicHole(cylinder(8, 2, 1.0)); }), "2 boundary loops"));
  // Around the tube of a torus, whose rest is a tube with two ends.
  EXPECT_TRUE(
    contains(messageOf<TopologyError>([] { cutGeodesicHole(torus(60, 16), holeAt(2.5, 0, 0, 0.3)); }),
      "reaches around a handle"));
  EXPECT_TRUE(contains(
    messageOf<InvalidInput>([] { cutGeodesicHole(sphere(1), holeAt(0, 0, 1, 0.0)); }), "share"));
  EXPECT_TRUE(contains(
    messageOf<InvalidInput>([] { cutGeodesicHole(sphere(1), holeAt(0, 0, 1, 0.7)); }), "share"));
  EXPECT_TRUE(contains(
    messageOf<InvalidInput>([] { cutGeodesicHole(sphere(1), holeAt(NAN, 0, 1)); }), "not finite"));
  const std::string off = messageOf<InvalidInput>([] { cutGeodesicHole(sphere(3), holeAt(0, 0, 1.3)); });
  EXPECT_TRUE(contains(off, "the hole's point") && contains(off, "lies 0.3 off")) << off;
  EXPECT_THROW(cutGeodesicHole(sphere(1), {}, [](double, const char*) { return false; }), Cancelled);
}

} // namespace
