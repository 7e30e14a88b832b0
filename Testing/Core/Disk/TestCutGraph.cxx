// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Disk/CutGraph.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <cmath>
#include <map>

namespace
{

using namespace flattening;
using namespace flattening::samples;

double lengthOf(const TriangleMesh& mesh, const std::vector<MeshEdge>& edges)
{
  double length = 0.0;
  for (const MeshEdge& edge : edges)
  {
    length += (mesh.Vertices.row(edge[0]) - mesh.Vertices.row(edge[1])).norm();
  }
  return length;
}

// The vertices of column i of a torus of n x m.
std::vector<int> meridian(int i, int m)
{
  std::vector<int> loop;
  for (int j = 0; j < m; ++j)
  {
    loop.push_back(i * m + j);
  }
  return loop;
}

void expectDiskOfTheSameArea(const TriangleMesh& mesh, const CutSurface& cut)
{
  requireDisk(cut.Surface.Mesh);
  EXPECT_EQ(
    faceAreas(cut.Surface.Mesh.Vertices, cut.Surface.Mesh.Faces), faceAreas(mesh.Vertices, mesh.Faces));
}

// Two tori joined by a tube: genus 2, and a meridian of each.
struct DoubleTorus
{
  TriangleMesh Mesh;
  std::vector<std::vector<int>> Loops;
};

// The outermost square of each torus is removed, a band of triangles joins the rims.
DoubleTorus doubleTorus(int n, int m)
{
  const TriangleMesh left = torus(n, m);
  TriangleMesh right = left;
  right.Vertices.col(0) *= -1.0; // turned about z: outermost column first again
  right.Vertices.col(1) *= -1.0;
  right = moved(right, 6.0, 0.0, 0.0);
  DoubleTorus result;
  result.Mesh = both(withoutFaces(left, { 0, 1 }), withoutFaces(right, { 0, 1 }));
  const std::array<int, 4> a{ 0, m, m + 1, 1 }; // around the square, surface outside
  const std::array<int, 4> b{ n * m, n * m + 1, n * m + m + 1, n * m + m };
  FaceMatrix& faces = result.Mesh.Faces;
  const Eigen::Index old = faces.rows();
  faces.conservativeResize(old + 8, 3);
  for (int k = 0; k < 4; ++k)
  {
    const int next = (k + 1) % 4;
    faces.row(old + 2 * k) << a[k], a[next], b[k];
    faces.row(old + 2 * k + 1) << b[k], a[next], b[next];
  }
  result.Loops = { meridian(n / 2, m), meridian(n + n / 2, m) };
  return result;
}

TEST(CutGraph, OfATorusIsAMeridianAndTheInnerEquator)
{
  constexpr int n = 60;
  constexpr int m = 24;
  const TriangleMesh mesh = torus(n, m);
  const std::vector<std::vector<int>> loops{ meridian(7, m) };
  const std::vector<MeshEdge> graph = shortCutGraph(mesh, loops);
  // The shortest way around from the meridian to itself has radius 1.5.
  const double inner = 2 * n * 1.5 * std::sin(Pi / n);
  const double around = 2 * m * 0.5 * std::sin(Pi / m);
  EXPECT_NEAR(lengthOf(mesh, graph), inner + around, 1e-12);
  EXPECT_EQ(graph.size(), std::size_t(n + m));
  expectDiskOfTheSameArea(mesh, cutToDisk(mesh, loops));
}

TEST(CutGraph, JoinsTheBoundariesOfASurfaceWithHoles)
{
  // A sphere with eight holes at the corners of a cube has no handles.
  const TriangleMesh whole = sphere(5);
  std::set<int> removed;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Eigen::Vector3d at =
      Eigen::Vector3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1).normalized();
    for (int f = 0; f < whole.faceCount(); ++f)
    {
      if (whole.Vertices.row(whole.Faces(f, 0)).dot(at) > std::cos(0.3))
      {
        removed.insert(f);
      }
    }
  }
  const DerivedMesh pierced = extractFaces(whole,
    [&]
    {
      std::vector<int> kept;
      for (int f = 0; f < whole.faceCount(); ++f)
      {
        if (!removed.count(f))
        {
          kept.push_back(f);
        }
      }
      return kept;
    }());
  ASSERT_EQ(analyseTopology(pierced.Mesh.Faces, pierced.Mesh.vertexCount()).BoundaryLoops.size(), 8u);
  const std::vector<MeshEdge> graph = shortCutGraph(pierced.Mesh, {});
  expectDiskOfTheSameArea(pierced.Mesh, cutToDisk(pierced.Mesh, {}));
  // Seven edges of the cube's tree, each acos(1/3) long less the two radii; edges of a mesh are up to
  // 15 % longer than the arc.
  const double tree = 7 * (std::acos(1.0 / 3.0) - 2 * 0.3);
  EXPECT_GT(lengthOf(pierced.Mesh, graph), 0.9 * tree);
  EXPECT_LT(lengthOf(pierced.Mesh, graph), 1.15 * tree);
}

TEST(CutGraph, OpensADoubleTorusAndKeepsEveryTriangle)
{
  const DoubleTorus two = doubleTorus(40, 16);
  ASSERT_EQ(analyseTopology(two.Mesh.Faces, two.Mesh.vertexCount()).Genus, 2);
  expectDiskOfTheSameArea(two.Mesh, cutToDisk(two.Mesh, two.Loops));

  // With a hole of its own on top: three boundaries more than without the loops.
  const TriangleMesh pierced = withoutFaces(two.Mesh, { 500, 501 });
  const CutSurface cut = cutToDisk(pierced, two.Loops);
  expectDiskOfTheSameArea(pierced, cut);
}

TEST(CutGraph, HasNoDeadEnds)
{
  const DoubleTorus two = doubleTorus(40, 16);
  std::map<int, int> degree;
  for (const MeshEdge& edge : shortCutGraph(two.Mesh, two.Loops))
  {
    ++degree[edge[0]];
    ++degree[edge[1]];
  }
  for (const auto& [vertex, edges] : degree)
  {
    EXPECT_GE(edges, 2) << vertex;
  }
}

TEST(CutGraph, DoesNotDependOnTheUnit)
{
  const DoubleTorus two = doubleTorus(40, 16);
  const std::vector<MeshEdge> graph = shortCutGraph(two.Mesh, two.Loops);
  for (const double scale : { std::ldexp(1.0, -30), 1.0, std::ldexp(1.0, 30) })
  {
    TriangleMesh scaled = two.Mesh;
    scaled.Vertices *= scale;
    EXPECT_EQ(shortCutGraph(scaled, two.Loops), graph);
  }
}

TEST(CutGraph, RejectsLoopsThatDoNotOpenTheSurface)
{
  const TriangleMesh mesh = torus(30, 12);
  EXPECT_TRUE(contains(messageOf<TopologyError>([&] { shortCutGraph(mesh, {}); }), "genus 1"));
  EXPECT_TRUE(contains(messageOf<TopologyError>(
                         [&] {
                           shortCutGraph(mesh, { meridian(0, 12), meridian(9, 12) });
                         }),
    "2 parts"));
  EXPECT_TRUE(
    contains(messageOf<TopologyError>([] { shortCutGraph(sphere(2), {}); }), "closed surface"));
  EXPECT_TRUE(contains(messageOf<InvalidInput>(
                         [&] {
                           shortCutGraph(mesh, { { 0, 5, 70 } });
                         }),
    "no edge"));
  EXPECT_THROW(
    shortCutGraph(mesh, { meridian(0, 12) }, [](double, const char*) { return false; }), Cancelled);
}

} // namespace
