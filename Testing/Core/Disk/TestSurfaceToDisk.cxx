// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Disk/SurfaceToDisk.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/IsotropicRemeshing.h"
#include "Repair/HoleFilling.h"
#include "Support/SampleSurfaces.h"

#include <algorithm>
#include <set>

namespace
{

using namespace flattening;
using namespace flattening::samples;

double weightError(const VertexOrigins& origins)
{
  return (origins * Eigen::VectorXd::Ones(origins.cols()) - Eigen::VectorXd::Ones(origins.rows()))
    .cwiseAbs()
    .maxCoeff();
}

TEST(HoleFilling, ClosesOneEndOfATube)
{
  constexpr int n = 60;
  TriangleMesh tube = cylinder(n, 20, 3.0);
  for (int v = 0; v < tube.vertexCount(); ++v)
  {
    tube.Vertices.row(v).head<2>() *= 1.0 + 0.1 * tube.Vertices(v, 2);
  }
  // The loop of the lowest vertices.
  auto loops = analyseTopology(tube.Faces, tube.vertexCount()).BoundaryLoops;
  ASSERT_EQ(loops.size(), 2u);
  loops.erase(loops.begin() + (loops[0][0] == 0 ? 1 : 0));
  const FilledSurface filled = fillHoles(tube, loops);
  EXPECT_EQ(filled.FilledHoles, 1);
  EXPECT_NEAR(filled.FilledArea, 0.5 * n * std::sin(2.0 * Pi / n), 1e-12); // radius 1 at z = 0
  const DerivedMesh& surface = filled.Surface;
  const std::vector<int> boundary = requireDisk(surface.Mesh);
  for (const int v : boundary)
  {
    EXPECT_EQ(surface.Mesh.Vertices(v, 2), 3.0);
  }
  // Old vertices and faces come first and unchanged; the patch is refined, flat, and made of its rim
  // alone.
  EXPECT_EQ(surface.Mesh.Vertices.topRows(tube.vertexCount()), tube.Vertices);
  EXPECT_GT(surface.Mesh.vertexCount(), tube.vertexCount() + 20);
  EXPECT_LT(weightError(surface.Vertices), 1e-14);
  EXPECT_LT((surface.Vertices * tube.Vertices - surface.Mesh.Vertices).cwiseAbs().maxCoeff(), 1e-12);
  for (int f = 0; f < surface.Mesh.faceCount(); ++f)
  {
    EXPECT_EQ(surface.Faces[f], f < tube.faceCount() ? f : -1);
  }
}

TEST(HoleFilling, ClosesManyHolesOfASphere)
{
  const TriangleMesh whole = sphere(4);
  // Faces far from each other; the last hole is of four faces and has the longest boundary.
  const TriangleMesh pierced = withoutFaces(whole, { 0, 700, 1500, 2500, 4000, 4001, 4002, 4003 });
  auto loops = analyseTopology(pierced.Faces, pierced.vertexCount()).BoundaryLoops;
  ASSERT_EQ(loops.size(), 5u);
  loops.erase(loops.begin()); // the one of most edges
  const FilledSurface filled = fillHoles(pierced, loops);
  EXPECT_EQ(filled.FilledHoles, 4);
  EXPECT_EQ(requireDisk(filled.Surface.Mesh).size(), 6u);
  const Eigen::VectorXd areas = faceAreas(whole.Vertices, whole.Faces);
  EXPECT_NEAR(filled.FilledArea, areas[0] + areas[700] + areas[1500] + areas[2500], 1e-14);
}

TEST(IsotropicRemeshing, ReachesTheEdgeLengthAndTracesEveryVertex)
{
  const TriangleMesh old = cylinder(100, 30, 2.0);
  constexpr double length = 0.1;
  const DerivedMesh remeshed = remeshIsotropically(old, length);
  const TriangleMesh& mesh = remeshed.Mesh;
  // CGAL keeps edges between 4/5 and 4/3 of the length; few may be outside.
  EXPECT_GT(meanEdgeLength(mesh), 0.8 * length);
  EXPECT_LT(meanEdgeLength(mesh), 1.1 * length);
  EXPECT_NEAR(totalArea(mesh), totalArea(old), 0.01 * totalArea(old));
  const MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_EQ(topology.BoundaryLoops.size(), 2u);
  EXPECT_LT(weightError(remeshed.Vertices), 1e-14);
  EXPECT_LT((remeshed.Vertices * old.Vertices - mesh.Vertices).cwiseAbs().maxCoeff(), 1e-12);
  // A face's origin lies where the face does.
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const auto centroid = [](const TriangleMesh& m, int face)
    {
      return ((m.Vertices.row(m.Faces(face, 0)) + m.Vertices.row(m.Faces(face, 1)) +
                m.Vertices.row(m.Faces(face, 2))) /
              3.0)
        .eval();
    };
    EXPECT_LT((centroid(mesh, f) - centroid(old, remeshed.Faces[f])).norm(), 0.06) << f;
  }
}

TEST(IsotropicRemeshing, RejectsLengthsThatMakeNoSense)
{
  const TriangleMesh mesh = sphere(2);
  for (const double length : { -1.0, 0.0, double(INFINITY), double(NAN), 2.0 })
  {
    EXPECT_TRUE(contains(
      messageOf<InvalidInput>([&] { remeshIsotropically(mesh, length); }), "target edge length"))
      << length;
  }
}

TEST(SurfaceToDisk, OpensAClosedSurface)
{
  const TriangleMesh closed = sphere(4);
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Hole;
  const DiskSurface disk = surfaceToDisk(soupOf(closed), options);
  EXPECT_NEAR(disk.Report.RemovedArea, 1e-3 * totalArea(closed), 1e-12);
  EXPECT_GE(disk.Report.BoundaryVertices, 128);
  EXPECT_EQ(requireDisk(disk.Surface.Mesh).size(), std::size_t(disk.Report.BoundaryVertices));
  EXPECT_NEAR(disk.Report.BoundaryLength, 2.0 * Pi * std::sin(std::acos(1.0 - 2e-3)), 0.01 * 0.4);
  EXPECT_NEAR(disk.Report.SurfaceArea, totalArea(disk.Surface.Mesh), 1e-12);
}

TEST(SurfaceToDisk, AutomaticCutsAHoleWhereARegionLeavesNoRoomForARelief)
{
  const TriangleMesh closed = sphere(4);
  SurfaceToDiskOptions options;
  EXPECT_EQ(surfaceToDisk(closed, options).Report.ChosenCut, CutMode::Relief);
  options.RegionOfInterest.assign(closed.vertexCount(), 1);
  options.RegionOfInterest[7] = 0;
  const DiskSurface disk = surfaceToDisk(closed, options);
  EXPECT_EQ(disk.Report.ChosenCut, CutMode::Hole);
  EXPECT_TRUE(contains(disk.Report.ReasonOfCut, "no room")) << disk.Report.ReasonOfCut;
  EXPECT_LT((disk.Report.HoleCentre.transpose() - closed.Vertices.row(7)).norm(), 1e-9);
  options.Cut = CutMode::Relief;
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { surfaceToDisk(closed, options); }), "no room"));
}

// A sphere without a cap of 12 degrees around a pole has a strain of 0.9, and a half sphere one of 0.3.
TEST(SurfaceToDisk, AutomaticCutsAnOpenSurfaceWhoseStrainIsLarge)
{
  const TriangleMesh whole = sphere(4);
  const auto above = [&whole](double z)
  {
    std::set<int> faces;
    for (int f = 0; f < whole.faceCount(); ++f)
    {
      const Eigen::RowVector3i face = whole.Faces.row(f);
      const double height =
        whole.Vertices(face[0], 2) + whole.Vertices(face[1], 2) + whole.Vertices(face[2], 2);
      if (height > 3.0 * z)
      {
        faces.insert(f);
      }
    }
    return faces;
  };
  const TriangleMesh nearlyClosed = withoutFaces(whole, above(std::cos(0.21)));
  SurfaceToDiskOptions options;
  const SurfaceToDiskReport cut = surfaceToDisk(nearlyClosed, options).Report;
  EXPECT_EQ(cut.ChosenCut, CutMode::Relief);
  EXPECT_TRUE(contains(cut.ReasonOfCut, "curvature far from it")) << cut.ReasonOfCut;
  EXPECT_GT(cut.ReliefLength, 1.0);
  EXPECT_GT(cut.ReliefStrain[0], 0.7);
  EXPECT_LT(cut.ReliefStrain[1], 0.3);
  EXPECT_EQ(cut.RemovedArea, 0.0);

  const auto expectKept = [&](const TriangleMesh& mesh)
  {
    const SurfaceToDiskReport kept = surfaceToDisk(mesh, options).Report;
    EXPECT_FALSE(kept.ChosenCut);
    EXPECT_TRUE(contains(kept.ReasonOfCut, "is kept")) << kept.ReasonOfCut;
    EXPECT_EQ(kept.SeamLength, 0.0);
  };
  expectKept(withoutFaces(whole, above(0.0)));
  const TriangleMesh threeQuarters = withoutFaces(whole, above(0.5));
  expectKept(threeQuarters);
  options.FreeOutline = true;
  const SurfaceToDiskReport free = surfaceToDisk(threeQuarters, options).Report;
  EXPECT_EQ(free.ChosenCut, CutMode::Relief);
  EXPECT_GT(free.ReliefStrain[0], 0.3);
  EXPECT_LT(free.ReliefStrain[0], 0.7);
  EXPECT_GT(surfaceToDisk(nearlyClosed, options).Report.ReliefLength, 1.2 * cut.ReliefLength);
  options = {};
  options.Banks.assign(nearlyClosed.vertexCount(), 0);
  options.Remesh = true;
  expectKept(nearlyClosed);
  options = {};
  options.RegionOfInterest.assign(nearlyClosed.vertexCount(), 1);
  expectKept(nearlyClosed);
}

// The cut of a tetrahedron's only free edge would not open it, so that the edge is divided.
TEST(SurfaceToDisk, OpensTheSmallestClosedSurface)
{
  TriangleMesh tetrahedron;
  tetrahedron.Vertices.resize(4, 3);
  tetrahedron.Vertices << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
  tetrahedron.Faces.resize(4, 3);
  tetrahedron.Faces << 0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2;
  const DiskSurface disk = surfaceToDisk(tetrahedron);
  EXPECT_EQ(disk.Report.ChosenCut, CutMode::Relief);
  EXPECT_NEAR(disk.Report.SurfaceArea, 8.0 * std::sqrt(3.0), 1e-12);
  EXPECT_GE(disk.Report.BoundaryVertices, 128);
}

TEST(SurfaceToDisk, KeepsTheLongestBoundary)
{
  TriangleMesh tube = cylinder(60, 20, 3.0);
  for (int v = 0; v < tube.vertexCount(); ++v)
  {
    tube.Vertices.row(v).head<2>() *= 1.0 + 0.1 * tube.Vertices(v, 2);
  }
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Hole;
  options.FillLengthLimit = 7.0;
  const DiskSurface disk = surfaceToDisk(tube, options);
  EXPECT_EQ(disk.Report.FilledHoles, 1);
  EXPECT_EQ(disk.Report.HoleRadius, 0.0);
  EXPECT_NEAR(disk.Report.BoundaryLength, 1.3 * 120.0 * std::sin(Pi / 60), 1e-12);
}

// A sphere without one triangle is a disk, but its boundary is too short for a flat map.
TEST(SurfaceToDisk, WidensATinyBoundary)
{
  const TriangleMesh whole = sphere(5);
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Hole;
  const DiskSurface disk = surfaceToDisk(withoutFaces(whole, { 4321, 99 }), options);
  EXPECT_EQ(disk.Report.FilledHoles, 2);
  EXPECT_NEAR(disk.Report.RemovedArea, 1e-3 * totalArea(whole), 1e-9);
  EXPECT_GE(disk.Report.BoundaryVertices, 128);
  const auto centroid = [&whole](int f)
  {
    return ((whole.Vertices.row(whole.Faces(f, 0)) + whole.Vertices.row(whole.Faces(f, 1)) +
              whole.Vertices.row(whole.Faces(f, 2))) /
            3.0)
      .eval();
  };
  const double distance = std::min((centroid(4321) - disk.Report.HoleCentre.transpose()).norm(),
    (centroid(99) - disk.Report.HoleCentre.transpose()).norm());
  EXPECT_LT(distance, 1e-9);
  options.Cut = CutMode::Automatic;
  const DiskSurface automatic = surfaceToDisk(withoutFaces(whole, { 4321, 99 }), options);
  EXPECT_EQ(automatic.Report.FilledHoles, 2);
  EXPECT_EQ(automatic.Report.ChosenCut, CutMode::Relief);
}

// A loop that is longer than the limit is not filled, however small a share of the area it surrounds.
TEST(SurfaceToDisk, KeepsAPunctureThatIsTooLongToBeFilled)
{
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Hole;
  const TriangleMesh pierced = withoutFaces(sphere(4), { 99 });
  const double length = loopLength(pierced.Vertices, requireDisk(pierced));
  options.FillLengthLimit = 1.001 * length;
  EXPECT_EQ(surfaceToDisk(pierced, options).Report.FilledHoles, 1);
  options.FillLengthLimit = 0.999 * length;
  const DiskSurface disk = surfaceToDisk(pierced, options);
  EXPECT_EQ(disk.Report.FilledHoles, 0);
  EXPECT_NEAR(disk.Report.BoundaryLength, length, 1e-12);
}

TEST(SurfaceToDisk, NamesTheRemedyForABoundaryThatIsTooLong)
{
  SurfaceToDiskOptions options;
  const TriangleMesh tube = cylinder(60, 20, 3.0);
  const std::string ofTube = messageOf<InvalidInput>([&] { surfaceToDisk(tube, options); });
  EXPECT_TRUE(contains(ofTube, "set Cut to Seam")) << ofTube;
  EXPECT_TRUE(contains(ofTube, "raise Fill Length Limit")) << ofTube;
  options.Cut = CutMode::Seam;
  EXPECT_EQ(surfaceToDisk(tube, options).Report.ChosenCut, CutMode::Seam);
  // The ends of a funnel differ too much for a seam from one to the other.
  TriangleMesh funnel = cylinder(60, 20, 0.1);
  for (auto vertex : funnel.Vertices.rowwise())
  {
    vertex.head<2>() *= 1.0 + 40.0 * vertex.z();
  }
  options.FillLengthLimit = 1.0;
  for (const CutMode cut : { CutMode::Automatic, CutMode::Seam })
  {
    options.Cut = cut;
    const std::string ofFunnel = messageOf<InvalidInput>([&] { surfaceToDisk(funnel, options); });
    EXPECT_FALSE(contains(ofFunnel, "Seam")) << ofFunnel;
    EXPECT_TRUE(contains(ofFunnel, "raise Fill Length Limit")) << ofFunnel;
  }
}

// A polygon of three vertices covers less than half of the disk.
TEST(SurfaceToDisk, ABoundaryOfThreeVerticesIsRefined)
{
  const TriangleMesh pyramid = meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.3, 0.3, 1 } },
    { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Hole;
  options.FlattenFolds = false; // or the tip would be
  const DiskSurface disk = surfaceToDisk(pyramid, options);
  EXPECT_GE(disk.Report.BoundaryVertices, 8);
  EXPECT_LE(disk.Report.BoundaryVertices, 16);
  EXPECT_NEAR(disk.Report.SurfaceArea, faceAreas(pyramid.Vertices, pyramid.Faces).sum(), 1e-12);
  options.Hole.BoundaryVertices = 3;
  EXPECT_EQ(surfaceToDisk(pyramid, options).Report.BoundaryVertices, 3);
}

TEST(SurfaceToDisk, NamesTheGenusIfHandlesAreErrors)
{
  SurfaceToDiskOptions options;
  options.Handles = HandleMode::Error;
  std::string message = messageOf<TopologyError>([&] { surfaceToDisk(torus(30, 12), options); });
  EXPECT_TRUE(contains(message, "genus 1") && contains(message, "Remove or Cut")) << message;
  // A torus with a hole in it has a boundary, and a handle all the same.
  const TriangleMesh pierced = withoutFaces(torus(30, 12), { 0, 1, 2, 3 });
  message = messageOf<TopologyError>([&] { surfaceToDisk(pierced, options); });
  EXPECT_TRUE(contains(message, "genus 1")) << message;
}

TEST(SurfaceToDisk, RemovesAHandle)
{
  const TriangleMesh whole = torus(60, 24);
  const DiskSurface disk = surfaceToDisk(whole);
  EXPECT_EQ(disk.Report.Genus, 1);
  EXPECT_EQ(disk.Report.Handles.Handles, 1);
  ASSERT_EQ(disk.Report.Handles.LoopLengths.size(), 1u);
  // The area of the disk is the area before, less what was removed, plus what was added.
  const SurfaceToDiskReport& report = disk.Report;
  EXPECT_NEAR(report.SurfaceArea,
    totalArea(whole) - report.Handles.RemovedArea + report.Handles.AddedArea - report.RemovedArea,
    1e-6 * totalArea(whole)); // the hole's boundary is conditioned
  EXPECT_EQ(report.SelfIntersectionsBefore, 0);
  EXPECT_EQ(report.SelfIntersections, 0);
}

TEST(SurfaceToDisk, CutsAHandleOpenAndLosesNothing)
{
  const TriangleMesh whole = torus(60, 24);
  SurfaceToDiskOptions options;
  options.Handles = HandleMode::Keep;
  const DiskSurface disk = surfaceToDisk(whole, options);
  EXPECT_EQ(disk.Report.Genus, 1);
  EXPECT_EQ(disk.Report.Handles.Handles, 0);
  EXPECT_NEAR(disk.Report.SurfaceArea, totalArea(whole), 1e-12 * totalArea(whole));
  EXPECT_NEAR(disk.Report.SeamLength, 0.5 * disk.Report.BoundaryLength, 1e-12);
  EXPECT_EQ(disk.Report.SelfIntersections, 0); // the two sides of the seam do not count
  ASSERT_EQ(disk.Seam.size(), std::size_t(disk.Surface.Mesh.vertexCount()));
  EXPECT_EQ(std::count(disk.Seam.begin(), disk.Seam.end(), 1), disk.Report.BoundaryVertices);
  EXPECT_GE(disk.Report.BoundaryVertices, 128);
}

// Radii 2 and 0.5: the hole is cut on the outer equator, the seam is a third of the inner one.
TEST(SurfaceToDisk, CutsHandlesAndTheHoleOrSeamAskedFor)
{
  const TriangleMesh whole = torus(90, 30);
  const double area = totalArea(whole);
  SurfaceToDiskOptions options;
  options.Handles = HandleMode::Keep;
  const double cutAlone = surfaceToDisk(whole, options).Report.SeamLength;

  options.Hole.Centre = Eigen::Vector3d(0, 2.5, 0);
  options.Hole.AreaFraction = 0.01;
  const DiskSurface hole = surfaceToDisk(whole, options); // requireDisk is part of it
  EXPECT_LT((hole.Report.HoleCentre - Eigen::Vector3d(0, 2.5, 0)).norm(), 0.05);
  EXPECT_NEAR(hole.Report.RemovedArea, 0.01 * area, 1e-5 * area);
  EXPECT_NEAR(hole.Report.SurfaceArea, 0.99 * area, 2e-5 * area);
  const double round = 2.0 * std::sqrt(Pi * 0.01 * area);
  EXPECT_NEAR(hole.Report.BoundaryLength, 2.0 * hole.Report.SeamLength + round, 0.05 * round);
  EXPECT_GT(hole.Report.SeamLength, Pi * 0.98);

  options.Hole = {};
  options.Cut = CutMode::Seam;
  EXPECT_EQ(surfaceToDisk(whole, options).Report.SeamLength, cutAlone); // no points, no further seam
  const double third = 2.0 * Pi / 3.0;
  options.SeamPoints = { { 1.5, 0, 0 }, { 1.5 * std::cos(third), 1.5 * std::sin(third), 0 } };
  const DiskSurface seam = surfaceToDisk(whole, options);
  EXPECT_NEAR(seam.Report.SurfaceArea, area, 1e-12 * area);
  EXPECT_NEAR(seam.Report.SeamLength, 0.5 * seam.Report.BoundaryLength, 1e-12 * area);
  EXPECT_EQ(seam.Report.RemovedArea, 0.0);
  // Every boundary vertex is flagged, and so are the ends of the seam, and nothing else.
  const std::vector<int> boundary = requireDisk(seam.Surface.Mesh);
  std::vector<char> onBoundary(seam.Seam.size(), 0);
  for (const int v : boundary)
  {
    onBoundary[v] = 1;
  }
  EXPECT_EQ(seam.Seam, onBoundary);
  // The seam's third of the inner equator is part of it.
  int onThird = 0;
  for (const int v : boundary)
  {
    const Eigen::Vector3d x = seam.Surface.Mesh.Vertices.row(v);
    const double angle = std::atan2(x.y(), x.x());
    onThird += std::abs(x.head<2>().norm() - 1.5) < 0.01 && std::abs(x.z()) < 0.1 && angle > 0.01 &&
                   angle < third - 0.01
                 ? 1
                 : 0;
  }
  EXPECT_GE(onThird, 120);
}

TEST(SurfaceToDisk, CountsTheRegionThatTheCutOfHandlesRunsThrough)
{
  const TriangleMesh whole = torus(60, 24);
  SurfaceToDiskOptions options;
  options.Handles = HandleMode::Keep;
  const DiskSurface plain = surfaceToDisk(whole, options);
  EXPECT_EQ(plain.Report.SeamRegionPoints, 0);
  std::set<int> onCut; // vertices of the input
  for (int v = 0; v < plain.Surface.Mesh.vertexCount(); ++v)
  {
    if (plain.Seam[v] && plain.Surface.Vertices.innerVector(v).nonZeros() == 1)
    {
      onCut.insert(static_cast<int>(VertexOrigins::InnerIterator(plain.Surface.Vertices, v).col()));
    }
  }
  ASSERT_GT(onCut.size(), 40u);
  options.RegionOfInterest.assign(whole.vertexCount(), 1);
  EXPECT_EQ(surfaceToDisk(whole, options).Report.SeamRegionPoints, static_cast<int>(onCut.size()));
  for (const int v : onCut)
  {
    options.RegionOfInterest[v] = 0;
  }
  EXPECT_EQ(surfaceToDisk(whole, options).Report.SeamRegionPoints, 0);
}

TEST(SurfaceToDisk, CutsAlongASeamOrAPlane)
{
  const TriangleMesh closed = sphere(4);
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Seam;
  options.SeamPoints = { { 1, 0, 0 }, { 0, 1, 0 } };
  const DiskSurface seam = surfaceToDisk(closed, options);
  EXPECT_NEAR(seam.Report.SeamLength, 0.5 * Pi, 2e-3);
  EXPECT_NEAR(seam.Report.SurfaceArea, totalArea(closed), 1e-12 * totalArea(closed));
  EXPECT_EQ(seam.Report.RemovedArea, 0.0);

  // Two clicks at one place: the edges are 0.07 long.
  options.SeamPoints = { { 1, 0, 0 }, { 0.995, 0.1, 0 } };
  const std::string message = messageOf<InvalidInput>([&] { surfaceToDisk(closed, options); });
  EXPECT_TRUE(contains(message, "edges of the surface")) << message;
  options.SeamPoints = { { 1, 0, 0 }, { 0.9, 0.43, 0 } };
  EXPECT_NEAR(surfaceToDisk(closed, options).Report.SeamLength, 0.45, 0.02);

  options.Cut = CutMode::Plane;
  options.Plane.Origin = { 0, 0, 0.5 };
  options.Plane.Normal = { 0, 0, 3 };
  const DiskSurface cap = surfaceToDisk(closed, options);
  EXPECT_NEAR(cap.Report.SurfaceArea, Pi, 0.01 * Pi); // 2 pi (1 - 1/2)
  EXPECT_NEAR(cap.Report.SurfaceArea + cap.Report.RemovedArea, totalArea(closed), 1e-3);
  EXPECT_NEAR(cap.Report.BoundaryLength, 2.0 * Pi * std::sqrt(0.75), 0.01);
}

TEST(SurfaceToDisk, KeepsTheBoundaryAskedFor)
{
  TriangleMesh tube = cylinder(60, 20, 3.0);
  for (int v = 0; v < tube.vertexCount(); ++v)
  {
    tube.Vertices.row(v).head<2>() *= 1.0 + 0.1 * tube.Vertices(v, 2);
  }
  SurfaceToDiskOptions options;
  options.FillLengthLimit = 10.0;
  options.Boundary.By = BoundaryChoice::Rule::ClosestToPoint;
  options.Boundary.Point = { 0.5, 0, 0 };
  EXPECT_NEAR(surfaceToDisk(tube, options).Report.BoundaryLength, 120.0 * std::sin(Pi / 60), 1e-12);
  options.Boundary.By = BoundaryChoice::Rule::None;
  const DiskSurface closed = surfaceToDisk(tube, options);
  EXPECT_EQ(closed.Report.FilledHoles, 2);
  EXPECT_EQ(closed.Report.ChosenCut, CutMode::Relief);
  options.FillLengthLimit = 7.0; // the loops are 6.3 and 8.2 long
  const std::string message = messageOf<InvalidInput>([&] { surfaceToDisk(tube, options); });
  EXPECT_TRUE(contains(message, "8.1")) << message;
}

TEST(SurfaceToDisk, NamesAOneSidedSurface)
{
  const std::string message = messageOf<TopologyError>([] { surfaceToDisk(moebiusStrip(12)); });
  EXPECT_TRUE(contains(message, "one-sided") && contains(message, "Clip")) << message;
}

TEST(SurfaceToDisk, KeepsTheComponentAskedFor)
{
  TriangleMesh small = moved(sphere(2), 5, 0, 0);
  TriangleMesh big = sphere(3);
  big.Vertices *= 2.0;
  const TriangleMesh two = both(small, big); // the smaller one first
  const DiskSurface largest = surfaceToDisk(two);
  EXPECT_EQ(largest.Report.Components, 2);
  EXPECT_NEAR(largest.Report.SurfaceArea, totalArea(big), 1e-12 * totalArea(big));

  SurfaceToDiskOptions options;
  options.Component.By = ComponentChoice::Rule::ClosestToPoint;
  options.Component.Point = Eigen::Vector3d(5, 0, 0);
  const DiskSurface closest = surfaceToDisk(two, options);
  EXPECT_NEAR(closest.Report.SurfaceArea, totalArea(small), 1e-12 * totalArea(small));
  options.Component.Point = Eigen::Vector3d(2.9, 0, 0); // 0.9 from the big one, 1.1 from the small one
  EXPECT_NEAR(surfaceToDisk(two, options).Report.SurfaceArea, largest.Report.SurfaceArea, 1e-12);

  options.Component.By = ComponentChoice::Rule::ByIndex;
  options.Component.Index = 1; // by area: the smaller one
  EXPECT_EQ(surfaceToDisk(two, options).Report.SurfaceArea, closest.Report.SurfaceArea);
  EXPECT_NEAR(closest.Report.DroppedComponentArea, totalArea(big), 1e-9);
  options.Component.Index = 2;
  const std::string message = messageOf<InvalidInput>([&] { surfaceToDisk(two, options); });
  EXPECT_TRUE(contains(message, "component 2") && contains(message, "has 2")) << message;
}

// The hole is cut after remeshing, so its boundary keeps its vertices.
TEST(SurfaceToDisk, RemeshesBeforeItCuts)
{
  SurfaceToDiskOptions options;
  options.Remesh = true;
  options.TargetEdgeLength = 0.15;
  const DiskSurface disk = surfaceToDisk(sphere(4), options);
  EXPECT_GE(disk.Report.BoundaryVertices, 128);
  EXPECT_EQ(disk.Report.RemeshEdgeLength, 0.15);
  EXPECT_GT(disk.Report.SmallestAngle, 1.0);
  options.TargetEdgeLength = 0.0;
  options.RelativeEdgeLength = 1.5;
  EXPECT_NEAR(
    surfaceToDisk(sphere(4), options).Report.RemeshEdgeLength, 1.5 * meanEdgeLength(sphere(4)), 1e-12);
}

// The boundary of a plane or a label is there before remeshing, which makes its edges as long as others.
TEST(SurfaceToDisk, ACutOfAnyKindHasTheVerticesAskedFor)
{
  const TriangleMesh closed = sphere(3);
  SurfaceToDiskOptions options;
  options.CountSelfIntersections = false;
  options.Plane = { { 0.05, 0.1, 0.2 }, { 0.3, 0.1, 1.0 } };
  options.Labelled.resize(closed.faceCount());
  for (int f = 0; f < closed.faceCount(); ++f)
  {
    options.Labelled[f] = faceCorners(closed, f).col(2).mean() > 0.5;
  }
  for (const CutMode cut :
    { CutMode::Hole, CutMode::Seam, CutMode::Relief, CutMode::Plane, CutMode::Label })
  {
    for (const bool remesh : { false, true })
    {
      for (const int wanted : { 128, 500 })
      {
        SCOPED_TRACE(std::to_string(static_cast<int>(cut)) + (remesh ? " remeshed " : " raw ") +
                     std::to_string(wanted));
        options.Cut = cut;
        options.Remesh = remesh;
        options.Hole.BoundaryVertices = wanted;
        const DiskSurface disk = surfaceToDisk(closed, options);
        EXPECT_EQ(disk.Report.ChosenCut, cut);
        EXPECT_GE(disk.Report.BoundaryVertices, wanted);
        EXPECT_LE(disk.Report.BoundaryVertices, 3 * wanted);
        EXPECT_GT(disk.Report.SmallestAngle, 1.0);
      }
    }
  }
}

// A strip of 1e-9 times 2 at the edge of a cube.
TEST(SurfaceToDisk, AThinCutHasTheVerticesAskedFor)
{
  TriangleMesh cube = meshOf({ { 0, 0, 0 },
                               { 2, 0, 0 },
                               { 0, 2, 0 },
                               { 2, 2, 0 },
                               { 0, 0, 2 },
                               { 2, 0, 2 },
                               { 0, 2, 2 },
                               { 2, 2, 2 } },
    { { 0, 2, 3 },
      { 0, 3, 1 },
      { 4, 5, 7 },
      { 4, 7, 6 },
      { 0, 1, 5 },
      { 0, 5, 4 },
      { 2, 6, 7 },
      { 2, 7, 3 },
      { 0, 4, 6 },
      { 0, 6, 2 },
      { 1, 3, 7 },
      { 1, 7, 5 } });
  SurfaceToDiskOptions options;
  options.Cut = CutMode::Plane;
  options.Plane = { { 2.0, 2.0 - 1e-9, 0.0 }, { 1.0, 1.0, 0.0 } };
  const DiskSurface disk = surfaceToDisk(cube, options);
  EXPECT_GE(disk.Report.BoundaryVertices, 128);
  EXPECT_NEAR(disk.Report.BoundaryLength, 4.0, 1e-5);
}

TEST(SurfaceToDisk, SlitsOfNonManifoldEdgesDoNotStay)
{
  // Two spheres share an edge: an edge of one is moved onto an edge of the other.
  TriangleMesh a = sphere(3);
  TriangleMesh b = moved(sphere(3), 0, 0, 2.5);
  const int u = a.Faces(0, 0);
  const int v = a.Faces(0, 1);
  b.Vertices.row(u) = a.Vertices.row(u);
  b.Vertices.row(v) = a.Vertices.row(v);
  const DiskSurface disk = surfaceToDisk(both(a, b));
  EXPECT_EQ(disk.Report.Repair.SplitPoints, 2);
  EXPECT_EQ(disk.Report.Components, 2);
  EXPECT_EQ(disk.Report.FilledHoles, 0);
  EXPECT_EQ(disk.Report.ChosenCut, CutMode::Relief);
}

TEST(SurfaceToDisk, GivesTheSameTwice)
{
  TriangleMesh cigar = sphere(4);
  cigar.Vertices.col(2) *= 3.0;
  SurfaceToDiskOptions options;
  options.Remesh = true;
  options.TargetEdgeLength = 0.1;
  const DiskSurface one = surfaceToDisk(cigar, options);
  const DiskSurface two = surfaceToDisk(cigar, options);
  EXPECT_EQ(one.Surface.Mesh.Faces, two.Surface.Mesh.Faces);
  EXPECT_EQ(one.Surface.Mesh.Vertices, two.Surface.Mesh.Vertices);
}

TEST(SurfaceToDisk, ReportsProgressThatNeverFallsAndStopsWhenTold)
{
  double last = 0.0;
  SurfaceToDiskOptions options;
  options.Remesh = true;
  options.TargetEdgeLength = 0.15;
  surfaceToDisk(sphere(4),
    options,
    [&last](double fraction, const char*)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return true;
    });
  EXPECT_EQ(last, 1.0);
  for (const double stop : { 0.0, 0.3, 0.6, 0.9 })
  {
    EXPECT_THROW(surfaceToDisk(
                   sphere(4), options, [stop](double fraction, const char*) { return fraction < stop; }),
      Cancelled);
  }
}

TEST(SurfaceToDisk, RejectsOptionsThatMakeNoSense)
{
  SurfaceToDiskOptions options;
  options.MergeTolerance = -1.0;
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { surfaceToDisk(sphere(1), options); }), "merge tolerance"));
  options.MergeTolerance = 10.0; // everything becomes one point
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { surfaceToDisk(sphere(1), options); }), "zero area"));
}

// One point far off makes triangles whose sizes differ by any factor.
TEST(SurfaceToDisk, EndsWhereAPointLiesFarOff)
{
  for (const double distance : { 1e3, 1e9, 1e15, 1e30 })
  {
    SCOPED_TRACE(distance);
    for (const CutMode cut : { CutMode::Hole, CutMode::Seam })
    {
      TriangleMesh mesh = sphere(3);
      mesh.Vertices.row(100) << distance, 0.3 * distance, 0.1;
      SurfaceToDiskOptions options;
      options.Cut = cut;
      try
      {
        EXPECT_EQ(requireDisk(surfaceToDisk(mesh, options).Surface.Mesh).empty(), false);
      }
      catch (const FlatteningError& error)
      {
        EXPECT_GE(distance, 1e15) << error.what();
        EXPECT_TRUE(contains(error.what(), ": ")) << error.what(); // the cause and the remedy
      }
    }
  }
}

// Geodesics over triangles that are longer than wide by more than the digits of a double are not exact.
TEST(SurfaceToDisk, EndsWhereTheSurfaceIsStretched)
{
  for (const double stretch : { 1e3, 1e6, 1e9, 2e9, 1e12, 1e15 })
  {
    SCOPED_TRACE(stretch);
    for (const int level : { 2, 3 })
    {
      TriangleMesh mesh = sphere(level);
      mesh.Vertices.col(0) *= stretch;
      SurfaceToDiskOptions options;
      options.Cut = CutMode::Seam;
      options.Handles = HandleMode::Keep;
      try
      {
        EXPECT_EQ(requireDisk(surfaceToDisk(mesh, options).Surface.Mesh).empty(), false);
      }
      catch (const FlatteningError& error)
      {
        EXPECT_GE(stretch, 1e6) << error.what();
        EXPECT_TRUE(contains(error.what(), ": ")) << error.what(); // the cause and the remedy
      }
    }
  }
}

// A triangle 20,000 times as long as wide, where neighbouring doubles are 0.002 apart and its width is
// 0.3: rounding moves the new points of its boundary.
TEST(SurfaceToDisk, MeasuresThePositionsThatArePutOut)
{
  TriangleMesh needle = meshOf({ { -12964636130576.727, -12236305799851.115, -4611197400399.479 },
                                 { -12964636130948.016, -12236305799850.883, -4611197400399.479 },
                                 { -12964636137190.785, -12236305799850.836, -4611197400399.479 } },
    { { 0, 1, 2 } });
  const DiskSurface disk = surfaceToDisk(needle);
  TriangleMesh result = disk.Surface.Mesh;
  ASSERT_GT(result.vertexCount(), 3);
  result.Vertices.rowwise() -= Eigen::RowVector3d(needle.Vertices.row(0));
  EXPECT_NEAR(disk.Report.SurfaceArea, totalArea(result), 1e-9 * totalArea(result));
  EXPECT_NEAR(disk.Report.BoundaryLength, loopLength(result.Vertices, disk.Boundary), 1e-5);
}

} // namespace
