// SPDX-License-Identifier: GPL-3.0-or-later
#include "EditableSurface.h"
#include "Errors.h"
#include "HalfedgeSurface.h"
#include "HandleLoops.h"
#include "HandleRemoval.h"
#include "HomologyLabels.h"
#include "MarchingTetrahedra.h"
#include "MeshTopology.h"
#include "SampleSurfaces.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <random>

namespace
{

using namespace flattening;
using namespace flattening::samples;

using Cell = std::array<int, 3>;

/// Boundary of a union of unit cubes, each side of 2 k x k triangles. No two cubes may meet in an edge
/// or a corner alone.
TriangleMesh boundaryOf(const std::set<Cell>& cubes, int k = 1)
{
  std::map<Cell, int> index;
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> faces;
  const auto vertex = [&](const Cell& at)
  {
    const auto [place, isNew] = index.try_emplace(at, static_cast<int>(vertices.size()));
    if (isNew)
    {
      vertices.push_back({ double(at[0]) / k, double(at[1]) / k, double(at[2]) / k });
    }
    return place->second;
  };
  for (const Cell& cube : cubes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const int side : { 0, 1 })
      {
        Cell neighbour = cube;
        neighbour[axis] += side ? 1 : -1;
        if (cubes.count(neighbour))
        {
          continue;
        }
        const int u = (axis + (side ? 1 : 2)) % 3;
        const int v = (axis + (side ? 2 : 1)) % 3;
        for (int i = 0; i < k; ++i)
        {
          for (int j = 0; j < k; ++j)
          {
            const auto corner = [&](int a, int b)
            {
              Cell at{ k * cube[0], k * cube[1], k * cube[2] };
              at[axis] += side * k;
              at[u] += i + a;
              at[v] += j + b;
              return vertex(at);
            };
            const int p = corner(0, 0);
            const int q = corner(1, 1);
            faces.push_back({ p, corner(1, 0), q });
            faces.push_back({ p, q, corner(0, 1) });
          }
        }
      }
    }
  }
  return meshOf(vertices, faces);
}

/// A slab of (2 n + 1) x 3 cubes, two high, with n square tunnels through it.
TriangleMesh slabWithTunnels(int n, int k = 1)
{
  std::set<Cell> cubes;
  for (int x = 0; x <= 2 * n; ++x)
  {
    for (int y = 0; y < 3; ++y)
    {
      for (int z = 0; z < 2; ++z)
      {
        if (x % 2 == 0 || y != 1)
        {
          cubes.insert({ x, y, z });
        }
      }
    }
  }
  return boundaryOf(cubes, k);
}

/// A block with n arches of cubes on it.
TriangleMesh blockWithHandles(int n, int k = 1)
{
  std::set<Cell> cubes;
  for (int x = 0; x < 2 * n; ++x)
  {
    for (int y = 0; y < 5; ++y)
    {
      for (int z = 0; z < 3; ++z)
      {
        cubes.insert({ x, y, z });
      }
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (const int z : { 3, 4, 5 })
    {
      cubes.insert({ 2 * i, 0, z });
      cubes.insert({ 2 * i, 4, z });
    }
    for (const int y : { 1, 2, 3 })
    {
      cubes.insert({ 2 * i, y, 5 });
    }
  }
  return boundaryOf(cubes, k);
}

std::size_t selfIntersections(const TriangleMesh& mesh)
{
  const SurfaceMesh surface = toSurfaceMesh(mesh);
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(pairs));
  return pairs.size();
}

/// Everything that must hold whatever the surface.
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

  // Old faces first; the area is what the report says.
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

  // Vertices are made of old ones, with weights; those kept moved no farther than reported.
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

TEST(HalfedgeSurface, CutsAndCapsALoop)
{
  const TriangleMesh mesh = torus(12, 8);
  HalfedgeSurface surface(mesh);
  EXPECT_EQ(surface.eulerCharacteristic(), 0);
  // Around the tube: vertices 0 .. 7.
  std::vector<int> loop;
  for (int j = 0; j < 8; ++j)
  {
    loop.push_back(surface.edgeBetween(j, (j + 1) % 8));
    ASSERT_EQ(surface.origin(loop.back()), j);
  }
  const int copies = surface.cut(loop);
  EXPECT_EQ(copies, 96);
  MeshTopology topology = analyseTopology(surface.mesh().Faces, surface.vertexCount());
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Genus, 0);
  ASSERT_EQ(topology.BoundaryLoops.size(), 2u);
  EXPECT_EQ(surface.boundaryLoops(), topology.BoundaryLoops);

  const int right = surface.addVertex({ 2.0, 0.0, 0.0 });
  const int left = surface.addVertex({ 2.0, 0.0, 0.0 });
  std::vector<std::array<int, 3>> caps;
  for (int j = 0; j < 8; ++j)
  {
    caps.push_back({ j, (j + 1) % 8, right });
    caps.push_back({ copies + (j + 1) % 8, copies + j, left });
  }
  surface.addFaces(caps);
  topology = analyseTopology(surface.mesh().Faces, surface.vertexCount());
  EXPECT_EQ(topology.eulerCharacteristic(), 2);
  EXPECT_EQ(surface.eulerCharacteristic(), 2);
  EXPECT_TRUE(topology.BoundaryLoops.empty());
  for (int h = 0; h < surface.halfedgeCount(); ++h)
  {
    ASSERT_EQ(surface.twin(surface.twin(h)), h);
    ASSERT_EQ(surface.origin(surface.twin(h)), surface.tip(h));
    ASSERT_EQ(surface.origin(surface.outgoing(surface.origin(h))), surface.origin(h));
  }
}

TEST(HalfedgeSurface, SplitsEveryInnerEdge)
{
  const TriangleMesh mesh = withoutFaces(torus(4, 3), { 0, 3, 12, 15 });
  HalfedgeSurface surface(mesh);
  HomologyLabels labels(surface);
  const int halfedges = surface.halfedgeCount();
  int splits = 0;
  for (int h = 0; h < halfedges; ++h)
  {
    if (h < surface.twin(h))
    {
      EXPECT_EQ(surface.splitEdge(h), mesh.vertexCount() + splits++);
      labels.followSplit(surface, h);
    }
  }
  const TriangleMesh split = surface.mesh();
  EXPECT_NEAR(totalArea(split), totalArea(mesh), 1e-14 * totalArea(mesh));
  EXPECT_EQ(analyseTopology(split.Faces, split.vertexCount()).BoundaryLoops,
    analyseTopology(mesh.Faces, mesh.vertexCount()).BoundaryLoops);
  for (int v = 0; v < surface.vertexCount(); ++v)
  {
    EXPECT_EQ(surface.origin(surface.outgoing(v)), v);
    EXPECT_EQ(surface.onBoundary(v), v < mesh.vertexCount());
  }
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    EXPECT_EQ(labels.hash(3 * f) ^ labels.hash(3 * f + 1) ^ labels.hash(3 * f + 2), 0u);
  }
}

TEST(HomologyLabels, AreCocyclesThatTellMeridianFromLongitude)
{
  HalfedgeSurface surface(torus(12, 8));
  HomologyLabels labels(surface);
  EXPECT_EQ(labels.genus(), 1);
  int labelled = 0;
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    EXPECT_EQ(labels.hash(3 * f) ^ labels.hash(3 * f + 1) ^ labels.hash(3 * f + 2), 0u);
    EXPECT_TRUE(HomologyLabels::isZero(labels.classOf({ 3 * f, 3 * f + 1, 3 * f + 2 })));
    labelled += labels.hash(3 * f) != 0;
  }
  EXPECT_GT(labelled, 0);
  const auto around = [&surface](int begin, int step, int count)
  {
    std::vector<int> loop;
    for (int i = 0; i < count; ++i)
    {
      loop.push_back(surface.edgeBetween(begin + i * step, begin + (i + 1) % count * step));
    }
    return loop;
  };
  const auto meridian = labels.classOf(around(0, 1, 8));
  const auto longitude = labels.classOf(around(0, 8, 12));
  EXPECT_FALSE(HomologyLabels::isZero(meridian));
  EXPECT_FALSE(HomologyLabels::isZero(longitude));
  EXPECT_NE(meridian, longitude);
  // Parallel curves are homologous.
  EXPECT_EQ(meridian, labels.classOf(around(40, 1, 8)));
  EXPECT_EQ(longitude, labels.classOf(around(5, 8, 12)));
}

TEST(HomologyLabels, CountABoundaryAsClosed)
{
  const TriangleMesh tube = cylinder(12, 6, 2.0);
  const HalfedgeSurface surface(tube);
  const HomologyLabels labels(surface);
  EXPECT_EQ(labels.genus(), 0);
  for (int h = 0; h < surface.halfedgeCount(); ++h)
  {
    EXPECT_EQ(labels.hash(h), 0u); // nothing to tell
  }
  const TriangleMesh pierced = withoutFaces(torus(20, 10), { 0, 1, 100, 101, 102 });
  EXPECT_EQ(HomologyLabels(HalfedgeSurface(pierced)).genus(), 1);
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
  // Around the tube, where it is thicker. Loops of edges are longer than circles.
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
  // Powers of two: the same to the last bit.
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

TEST(HandleRemoval, RefusesWhatIsNotOneSurface)
{
  EXPECT_TRUE(
    contains(messageOf<TopologyError>([] { removeHandles(both(sphere(1), moved(sphere(1), 5, 0, 0))); }),
      "not connected"));
  TriangleMesh turned = sphere(1);
  std::swap(turned.Faces(0, 1), turned.Faces(0, 2));
  EXPECT_TRUE(contains(messageOf<TopologyError>([&] { removeHandles(turned); }), "non-manifold"));
}

/// Cuts along all edges of the loops at once, by joining the corners on the two sides of all others.
MeshTopology topologyOfCut(const TriangleMesh& mesh, const std::vector<std::vector<int>>& loops)
{
  std::set<std::pair<int, int>> cut;
  for (const auto& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const int a = loop[i];
      const int b = loop[(i + 1) % loop.size()];
      cut.insert(std::minmax(a, b));
    }
  }
  std::vector<int> parent(3 * mesh.faceCount());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int i)
  {
    while (parent[i] != i)
    {
      i = parent[i] = parent[parent[i]];
    }
    return i;
  };
  const auto next = [](int corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
  const auto vertex = [&mesh](int corner) { return mesh.Faces(corner / 3, corner % 3); };
  std::map<std::pair<int, int>, int> sides; // from, to: corner at from
  for (int c = 0; c < 3 * mesh.faceCount(); ++c)
  {
    sides[{ vertex(c), vertex(next(c)) }] = c;
  }
  std::size_t found = 0;
  for (const auto& [ends, corner] : sides)
  {
    const auto opposite = sides.find({ ends.second, ends.first });
    if (cut.count(std::minmax(ends.first, ends.second)))
    {
      ++found;
    }
    else if (opposite != sides.end())
    {
      parent[root(corner)] = root(next(opposite->second));
      parent[root(next(corner))] = root(opposite->second);
    }
  }
  EXPECT_EQ(found, 2 * cut.size()); // all are edges
  FaceMatrix faces(mesh.faceCount(), 3);
  for (int c = 0; c < 3 * mesh.faceCount(); ++c)
  {
    faces(c / 3, c % 3) = root(c);
  }
  return analyseTopology(faces, 3 * mesh.faceCount());
}

void expectPlanarAfterCut(const TriangleMesh& mesh, int handles)
{
  const HandleLoops result = handleLoops(mesh);
  ASSERT_EQ(result.Loops.size(), std::size_t(handles));
  const MeshTopology before = analyseTopology(mesh.Faces, mesh.vertexCount());
  const MeshTopology topology = topologyOfCut(result.Surface.Mesh, result.Loops);
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_EQ(topology.BoundaryLoops.size(), before.BoundaryLoops.size() + 2 * handles);
  EXPECT_NEAR(totalArea(result.Surface.Mesh), totalArea(mesh), 1e-12 * totalArea(mesh));
  EXPECT_EQ(result.Surface.Mesh.Vertices.topRows(mesh.vertexCount()), mesh.Vertices);
  EXPECT_LT(
    (result.Surface.Vertices * mesh.Vertices - result.Surface.Mesh.Vertices).cwiseAbs().maxCoeff(),
    1e-12);
}

TEST(HandleLoops, LeaveAPlanarSurface)
{
  expectPlanarAfterCut(torus(30, 12), 1);
  expectPlanarAfterCut(withoutFaces(torus(20, 10), { 0, 1, 100, 101, 102, 300 }), 1);
  for (int n = 1; n <= 8; ++n)
  {
    SCOPED_TRACE(n);
    expectPlanarAfterCut(slabWithTunnels(n, 3), n);
    expectPlanarAfterCut(blockWithHandles(n, 2), n);
  }
  EXPECT_EQ(handleLoops(slabWithTunnels(3, 3)).Surface.Mesh.Faces, slabWithTunnels(3, 3).Faces);
}

// There is no room for loops that do not meet.
TEST(HandleLoops, SplitEdgesOfCoarseMeshes)
{
  for (int n = 1; n <= 8; ++n)
  {
    SCOPED_TRACE(n);
    expectPlanarAfterCut(slabWithTunnels(n), n);
    expectPlanarAfterCut(blockWithHandles(n), n);
  }
  expectPlanarAfterCut(torus(3, 3), 1);
  expectPlanarAfterCut(withoutFaces(torus(4, 3), { 0, 3, 12, 15 }), 1);
}

} // namespace
