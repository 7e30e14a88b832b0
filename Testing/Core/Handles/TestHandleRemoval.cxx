// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Handles/HandleRemoval.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshTopology.h"
#include "Support/CubeSurfaces.h"
#include "Support/MarchingTetrahedra.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <random>

namespace
{

using namespace flattening;
using namespace flattening::samples;

std::size_t selfIntersections(const TriangleMesh& mesh)
{
  const SurfaceMesh surface = toSurfaceMesh(mesh);
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(pairs));
  return pairs.size();
}

/// Expects all properties that hold for every surface.
void expectWithoutHandles(const TriangleMesh& mesh, const SurfaceWithoutHandles& result, int handles)
{
  const MeshTopology before = analyseTopology(mesh.Faces, mesh.vertexCount());
  const TriangleMesh& after = result.Surface.Mesh;
  const MeshTopology topology = analyseTopology(after.Faces, after.vertexCount());
  EXPECT_EQ(before.Genus, handles);
  EXPECT_EQ(result.Report.Handles, handles);
  EXPECT_EQ(result.Report.LoopLengths.size(), std::size_t(handles));
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.eulerCharacteristic(), before.eulerCharacteristic() + 2 * handles);
  EXPECT_EQ(topology.BoundaryLoops, before.BoundaryLoops);
  EXPECT_EQ(topology.Vertices, after.vertexCount());

  // Old faces come first, and the areas agree with the report.
  double capArea = 0.0;
  const Eigen::VectorXd areas = faceAreas(after.Vertices, after.Faces);
  for (int f = 0; f < after.faceCount(); ++f)
  {
    if (f < mesh.faceCount())
    {
      EXPECT_EQ(result.Surface.Faces[f], f);
    }
    capArea += result.Surface.Faces[f] < 0 ? areas[f] : 0.0;
  }
  const double area = totalArea(mesh);
  EXPECT_NEAR(result.Report.AddedArea, capArea, 1e-12 * area);
  EXPECT_NEAR(totalArea(after), area - result.Report.RemovedArea + capArea, 1e-12 * area);

  // The weights of every vertex sum to 1, and old vertices moved no farther than reported.
  const Eigen::VectorXd sums = result.Surface.Vertices * Eigen::VectorXd::Ones(mesh.vertexCount());
  EXPECT_LT((sums.array() - 1.0).abs().maxCoeff(), 1e-14);
  const double moved =
    (after.Vertices.topRows(mesh.vertexCount()) - mesh.Vertices).rowwise().norm().maxCoeff();
  EXPECT_LE(moved, result.Report.GreatestDisplacement);
  for (const auto& loop : before.BoundaryLoops)
  {
    for (const int v : loop)
    {
      EXPECT_EQ(after.Vertices.row(v), mesh.Vertices.row(v));
    }
  }
}

TEST(HandleRemoval, CutsATorusAroundItsTube)
{
  const TriangleMesh mesh = torus(48, 24);
  const SurfaceWithoutHandles result = removeHandles(mesh);
  expectWithoutHandles(mesh, result, 1);
  // The shortest loop is a 24-gon around the tube, the caps are near its disk.
  const double polygon = 24 * std::sin(Pi / 24);
  EXPECT_NEAR(result.Report.LoopLengths[0], polygon, 1e-12);
  EXPECT_NEAR(result.Report.AddedArea, 2 * Pi * 0.25, 0.05);
  EXPECT_GT(result.Surface.Mesh.vertexCount(), mesh.vertexCount() + 24 + 2 * 20); // inner vertices
  EXPECT_EQ(selfIntersections(result.Surface.Mesh), 0u);
  EXPECT_EQ(result.Report.PiercingCaps, 0);
  EXPECT_LT(result.Report.GreatestDisplacement, 0.5 * 2 * Pi * 2.5 / 48);
}

/// A solid torus whose tube is thinnest where a channel, closed at one end, runs inside along it.
TriangleMesh torusWithChannel(double large, double small)
{
  const int half = static_cast<int>(large + small) + 3;
  const int halfHeight = static_cast<int>(small) + 3;
  Volume volume({ 2 * half + 1, 2 * half + 1, 2 * halfHeight + 1 });
  for (int z = -halfHeight; z <= halfHeight; ++z)
  {
    for (int y = -half; y <= half; ++y)
    {
      for (int x = -half; x <= half; ++x)
      {
        const double angle = std::atan2(y, x);
        const double fromCentre = std::hypot(std::hypot(x, y) - large, z);
        const double tube = small * (1.0 - 0.2 * std::exp(-9.0 * angle * angle)) - fromCentre;
        const double end = std::clamp(angle, -0.5, 0.9);
        const double mouth = std::hypot(x - large * std::cos(0.9), y - large * std::sin(0.9));
        const double channel = 0.3 * small - (z > 0 ? mouth : half);
        const double along = 0.3 * small - std::hypot(fromCentre, large * (angle - end));
        volume.at(x + half, y + half, z + halfHeight) = std::min(tube, -std::max(channel, along)) + 1e-3;
      }
    }
  }
  return marchingTetrahedra(volume);
}

TEST(HandleRemoval, TakesALongerLoopWhereTheCapOfTheShortestWouldPierceTheSurface)
{
  const double small = 7.0;
  const TriangleMesh mesh = torusWithChannel(22.0, small);
  const SurfaceWithoutHandles result = removeHandles(mesh);
  expectWithoutHandles(mesh, result, 1);
  EXPECT_EQ(result.Report.PiercingCaps, 0);
  EXPECT_EQ(result.Report.NewIntersections, 0);
  EXPECT_EQ(selfIntersections(result.Surface.Mesh), 0u);
  // The loop runs around the tube where it is thicker. Loops of edges are longer than circles.
  EXPECT_GT(result.Report.LoopLengths[0], 2 * Pi * 0.9 * small);
  EXPECT_LT(result.Report.LoopLengths[0], 1.3 * 2 * Pi * small);
}

TEST(HandleRemoval, ReportsTheHandlesOfSolids)
{
  for (int n = 1; n <= 8; ++n)
  {
    for (const int k : { 1, 3 })
    {
      SCOPED_TRACE(std::to_string(n) + " at " + std::to_string(k));
      const TriangleMesh slab = slabWithTunnels(n, k);
      SurfaceWithoutHandles result = removeHandles(slab);
      expectWithoutHandles(slab, result, n);
      EXPECT_EQ(selfIntersections(result.Surface.Mesh), 0u);
      // A wall between tunnels is 1 x 2, a tunnel's mouth 1 x 1.
      for (const double length : result.Report.LoopLengths)
      {
        EXPECT_NEAR(length, 4.0, 1e-9);
      }

      const TriangleMesh block = blockWithHandles(n, k);
      result = removeHandles(block);
      expectWithoutHandles(block, result, n);
      EXPECT_EQ(selfIntersections(result.Surface.Mesh), 0u);
      for (const double length : result.Report.LoopLengths)
      {
        EXPECT_NEAR(length, 4.0, 1e-9); // around a bar
      }
    }
  }
}

TEST(HandleRemoval, LeavesTheBoundaryAsItIs)
{
  const TriangleMesh pierced = withoutFaces(torus(20, 10), { 0, 1, 100, 101, 102, 300 });
  expectWithoutHandles(pierced, removeHandles(pierced), 1);
  // Every vertex is on the boundary, until edges are split.
  const TriangleMesh strips = withoutFaces(torus(4, 3), { 0, 3, 12, 15 });
  expectWithoutHandles(strips, removeHandles(strips), 1);
}

TEST(HandleRemoval, DoesNothingWithoutHandles)
{
  const TriangleMesh mesh = sphere(3);
  const SurfaceWithoutHandles result = removeHandles(mesh);
  EXPECT_EQ(result.Report.Handles, 0);
  EXPECT_EQ(result.Surface.Mesh.Vertices, mesh.Vertices);
  EXPECT_EQ(result.Surface.Mesh.Faces, mesh.Faces);
}

TEST(HandleRemoval, WorksOnTheCoarsestTori)
{
  for (const auto& [n, m] : { std::pair(3, 3), std::pair(4, 3), std::pair(3, 5) })
  {
    const TriangleMesh mesh = torus(n, m);
    expectWithoutHandles(mesh, removeHandles(mesh), 1);
  }
  // Seven vertices, every two of them neighbours (Moebius 1861).
  std::vector<std::array<int, 3>> faces;
  std::vector<std::array<double, 3>> vertices;
  for (int i = 0; i < 7; ++i)
  {
    faces.push_back({ i, (i + 1) % 7, (i + 3) % 7 });
    faces.push_back({ i, (i + 3) % 7, (i + 2) % 7 });
    vertices.push_back({ std::cos(i), std::sin(2.0 * i), 0.1 * i * i });
  }
  const TriangleMesh moebius = meshOf(vertices, faces);
  expectWithoutHandles(moebius, removeHandles(moebius), 1);
}

TEST(HandleRemoval, DoesNotDependOnTheScale)
{
  const TriangleMesh mesh = slabWithTunnels(3, 2);
  const SurfaceWithoutHandles result = removeHandles(mesh);
  // Powers of two scale without rounding.
  for (const double scale : { std::ldexp(1.0, -30), std::ldexp(1.0, 30) })
  {
    TriangleMesh scaled = mesh;
    scaled.Vertices *= scale;
    const SurfaceWithoutHandles other = removeHandles(scaled);
    EXPECT_EQ(other.Surface.Mesh.Faces, result.Surface.Mesh.Faces);
    EXPECT_LT(
      (other.Surface.Mesh.Vertices / scale - result.Surface.Mesh.Vertices).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(HandleRemoval, GivesTheSameTwiceAndAlikeForOtherNumbers)
{
  TriangleMesh mesh = blockWithHandles(4, 3);
  // Bars of different thickness, so that no two loops are of equal length.
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    mesh.Vertices(v, 0) *= 1.0 + 0.02 * mesh.Vertices(v, 0);
    mesh.Vertices(v, 1) *= 1.0 + 0.03 * mesh.Vertices(v, 1);
  }
  const SurfaceWithoutHandles one = removeHandles(mesh);
  const SurfaceWithoutHandles two = removeHandles(mesh);
  EXPECT_EQ(one.Surface.Mesh.Faces, two.Surface.Mesh.Faces);
  EXPECT_EQ(one.Surface.Mesh.Vertices, two.Surface.Mesh.Vertices);

  std::mt19937 random(3);
  std::vector<int> number(mesh.vertexCount());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  std::vector<int> order(mesh.faceCount());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  TriangleMesh shuffled = mesh;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    shuffled.Vertices.row(number[v]) = mesh.Vertices.row(v);
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      shuffled.Faces(order[f], k) = number[mesh.Faces(f, (k + f) % 3)];
    }
  }
  const SurfaceWithoutHandles other = removeHandles(shuffled);
  expectWithoutHandles(shuffled, other, 4);
  std::vector<double> a = one.Report.LoopLengths;
  std::vector<double> b = other.Report.LoopLengths;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(a[i], b[i], 1e-9) << i;
  }
}

TEST(HandleRemoval, GivesTheSameWhereverMemoryIsAllocated)
{
  std::mt19937 random(5);
  std::vector<std::vector<char>> blocks(1000);
  const auto allocateAndFree = [&]
  {
    for (int i = 0; i < 1000; ++i)
    {
      blocks[random() % blocks.size()] =
        std::vector<char>(random() % (random() % 20 == 0 ? 50000 : 500));
    }
  };
  for (const TriangleMesh& mesh : { torus(60, 24), torus(48, 24), slabWithTunnels(2, 2) })
  {
    const DerivedMesh first = removeHandles(mesh).Surface;
    for (int repetition = 0; repetition < 20; ++repetition)
    {
      allocateAndFree();
      const DerivedMesh again = removeHandles(mesh).Surface;
      ASSERT_EQ(again.Mesh.Faces, first.Mesh.Faces);
      ASSERT_EQ(again.Mesh.Vertices, first.Mesh.Vertices);
      ASSERT_EQ((again.Vertices - first.Vertices).norm(), 0.0);
    }
  }
}

TEST(HandleRemoval, StopsWhenToldAndReportsProgressThatNeverFalls)
{
  const TriangleMesh mesh = slabWithTunnels(6, 2);
  double last = 0.0;
  removeHandles(mesh,
    [&last](double fraction, const char*)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return true;
    });
  EXPECT_GT(last, 0.5);
  EXPECT_THROW(
    removeHandles(mesh, [](double fraction, const char*) { return fraction < 0.5; }), Cancelled);
}

TEST(HandleRemoval, RejectsDisconnectedAndNonManifoldSurfaces)
{
  EXPECT_TRUE(
    contains(messageOf<TopologyError>([] { removeHandles(both(sphere(1), moved(sphere(1), 5, 0, 0))); }),
      "not connected"));
  TriangleMesh turned = sphere(1);
  std::swap(turned.Faces(0, 1), turned.Faces(0, 2));
  EXPECT_TRUE(contains(messageOf<TopologyError>([&] { removeHandles(turned); }), "oriented against"));
}

} // namespace
