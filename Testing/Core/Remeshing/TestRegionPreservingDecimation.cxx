// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/RegionPreservingDecimation.h"
#include "Support/SampleSurfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// A sphere of radius 1, open below z = -0.8.
TriangleMesh openSphere()
{
  const TriangleMesh whole = sphere(5);
  std::vector<int> kept;
  for (int f = 0; f < whole.faceCount(); ++f)
  {
    if (whole.Vertices(whole.Faces(f, 0), 2) > -0.8)
    {
      kept.push_back(f);
    }
  }
  return extractFaces(whole, kept).Mesh;
}

// The flags of two spherical caps.
std::vector<char> regionsOf(const TriangleMesh& mesh)
{
  std::vector<char> inRegion(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    inRegion[v] = mesh.Vertices(v, 2) > 0.95 || mesh.Vertices(v, 0) > 0.97 ? 1 : 0;
  }
  return inRegion;
}

int originalVertex(const DerivedMesh& derived, int v)
{
  const bool isKept = derived.Vertices.innerVector(v).nonZeros() == 1;
  return isKept ? static_cast<int>(VertexOrigins::InnerIterator(derived.Vertices, v).col()) : -1;
}

TEST(RegionPreservingDecimation, RegionsStayBitForBitWithTheirFaces)
{
  const TriangleMesh mesh = openSphere();
  const std::vector<char> inRegion = regionsOf(mesh);
  const DerivedMesh coarse = decimateContext(mesh, inRegion, 500);
  std::set<int> vertices;
  for (int v = 0; v < coarse.Mesh.vertexCount(); ++v)
  {
    const int original = originalVertex(coarse, v);
    if (original >= 0)
    {
      EXPECT_EQ(coarse.Mesh.Vertices.row(v), mesh.Vertices.row(original));
    }
    if (original >= 0 && inRegion[original])
    {
      EXPECT_TRUE(vertices.insert(original).second) << original << " is there twice";
    }
  }
  EXPECT_EQ(static_cast<long>(vertices.size()), std::count(inRegion.begin(), inRegion.end(), 1));

  // Every face with a corner in a region is still there, and is its own origin.
  std::set<int> faces;
  for (int f = 0; f < coarse.Mesh.faceCount(); ++f)
  {
    std::multiset<int> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners.insert(originalVertex(coarse, coarse.Mesh.Faces(f, k)));
    }
    const int from = coarse.Faces[f];
    const std::multiset<int> before{ mesh.Faces(from, 0), mesh.Faces(from, 1), mesh.Faces(from, 2) };
    if (corners == before)
    {
      faces.insert(from);
    }
  }
  int context = coarse.Mesh.faceCount();
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    if (inRegion[mesh.Faces(f, 0)] || inRegion[mesh.Faces(f, 1)] || inRegion[mesh.Faces(f, 2)])
    {
      EXPECT_TRUE(faces.count(f)) << f;
      --context;
    }
  }
  EXPECT_NEAR(context, 500, 50);
}

TEST(RegionPreservingDecimation, EdgesWithoutLengthBesideARegionLeaveItsFacesAlone)
{
  TriangleMesh mesh = openSphere();
  const std::vector<char> inRegion = regionsOf(mesh);
  std::vector<char> isFixed(mesh.vertexCount(), 0);
  std::set<std::vector<int>> faces; // with a corner in a region
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    std::vector<int> corners{ mesh.Faces(f, 0), mesh.Faces(f, 1), mesh.Faces(f, 2) };
    if (std::any_of(corners.begin(), corners.end(), [&inRegion](int v) { return inRegion[v] != 0; }))
    {
      std::for_each(corners.begin(), corners.end(), [&isFixed](int v) { isFixed[v] = 1; });
      std::sort(corners.begin(), corners.end());
      faces.insert(corners);
    }
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = mesh.Faces(f, k);
      const int next = mesh.Faces(f, (k + 1) % 3);
      if (isFixed[v] && !isFixed[next])
      {
        mesh.Vertices.row(next) = mesh.Vertices.row(v);
      }
    }
  }
  const DerivedMesh coarse = decimateContext(mesh, inRegion, 500);
  for (int f = 0; f < coarse.Mesh.faceCount(); ++f)
  {
    std::vector<int> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners.push_back(originalVertex(coarse, coarse.Mesh.Faces(f, k)));
    }
    std::sort(corners.begin(), corners.end());
    faces.erase(corners);
  }
  EXPECT_EQ(faces.size(), 0u);
}

TEST(RegionPreservingDecimation, TheSurfaceKeepsItsShapeAndTopology)
{
  const TriangleMesh mesh = openSphere();
  const DerivedMesh coarse = decimateContext(mesh, regionsOf(mesh), 1000);
  const MeshTopology before = analyseTopology(mesh.Faces, mesh.vertexCount());
  const MeshTopology after = analyseTopology(coarse.Mesh.Faces, coarse.Mesh.vertexCount());
  EXPECT_EQ(after.BoundaryLoops.size(), before.BoundaryLoops.size());
  EXPECT_EQ(after.Genus, before.Genus);
  EXPECT_NEAR(totalArea(coarse.Mesh), totalArea(mesh), 0.01 * totalArea(mesh));
  double greatest = 0.0;
  for (int v = 0; v < coarse.Mesh.vertexCount(); ++v)
  {
    greatest = std::max(greatest, std::abs(coarse.Mesh.Vertices.row(v).norm() - 1.0));
    double sum = 0.0;
    Eigen::RowVector3d from = Eigen::RowVector3d::Zero();
    for (VertexOrigins::InnerIterator weight(coarse.Vertices, v); weight; ++weight)
    {
      sum += weight.value();
      from += weight.value() * mesh.Vertices.row(weight.col());
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_LT((from - coarse.Mesh.Vertices.row(v)).norm(), 0.02);
  }
  EXPECT_LT(greatest, 0.02);
}

// A chain of square patches that share only a corner with the next: one or two faces of each meet there.
TriangleMesh chainOfPatches(int patches, int cells)
{
  const int corners = (cells + 1) * (cells + 1);
  TriangleMesh mesh;
  mesh.Vertices.resize(patches * (corners - 1) + 1, 3);
  std::vector<Eigen::RowVector3i> faces;
  for (int p = 0; p < patches; ++p)
  {
    const auto id = [&](int i, int j) { return p * (corners - 1) + i * (cells + 1) + j; };
    for (int i = 0; i <= cells; ++i)
    {
      for (int j = 0; j <= cells; ++j)
      {
        mesh.Vertices.row(id(i, j)) << p * cells + i, p * cells + j, 0.1 * ((i + 2 * j) % 3);
      }
    }
    for (int i = 0; i < cells; ++i)
    {
      for (int j = 0; j < cells; ++j)
      {
        const int a = p % 2 ? id(i, j) : id(i + 1, j); // where a diagonal begins
        const int b = p % 2 ? id(i + 1, j) : id(i + 1, j + 1);
        const int c = p % 2 ? id(i + 1, j + 1) : id(i, j + 1);
        const int d = p % 2 ? id(i, j + 1) : id(i, j);
        faces.emplace_back(a, b, c);
        faces.emplace_back(a, c, d);
      }
    }
  }
  mesh.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    mesh.Faces.row(static_cast<Eigen::Index>(f)) = faces[f];
  }
  return mesh;
}

// The Euler number, and the number of pieces if what shares a vertex is one piece.
std::pair<long, long> shapeOf(const TriangleMesh& mesh)
{
  std::vector<int> piece(mesh.vertexCount());
  std::iota(piece.begin(), piece.end(), 0);
  std::set<std::pair<int, int>> edges;
  std::set<int> vertices;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = mesh.Faces(f, k);
      const int b = mesh.Faces(f, (k + 1) % 3);
      vertices.insert(a);
      edges.insert(std::minmax(a, b));
      std::replace(piece.begin(), piece.end(), int{ piece[a] }, int{ piece[b] });
    }
  }
  std::set<int> pieces;
  std::for_each(vertices.begin(), vertices.end(), [&](int v) { pieces.insert(piece[v]); });
  return { static_cast<long>(vertices.size() + mesh.faceCount()) - static_cast<long>(edges.size()),
    static_cast<long>(pieces.size()) };
}

TEST(RegionPreservingDecimation, PatchesThatShareOnlyAVertexStayJoined)
{
  for (const int cells : { 1, 4 })
  {
    const TriangleMesh mesh = chainOfPatches(10, cells);
    std::vector<char> inRegion(mesh.vertexCount(), 0);
    inRegion[0] = 1;
    const DerivedMesh coarse = decimateContext(mesh, inRegion, 1);
    EXPECT_EQ(shapeOf(mesh), std::make_pair(1L, 1L));
    EXPECT_EQ(shapeOf(coarse.Mesh), shapeOf(mesh)) << cells;
    // All faces of single squares are at a shared corner, and stay.
    EXPECT_LE(coarse.Mesh.faceCount(), cells == 1 ? mesh.faceCount() : mesh.faceCount() / 2);
  }
}

TEST(RegionPreservingDecimation, AContextThatIsCoarseStaysAsItIs)
{
  const TriangleMesh mesh = openSphere();
  const DerivedMesh same = decimateContext(mesh, regionsOf(mesh), 1000000);
  EXPECT_TRUE(same.Mesh.Vertices == mesh.Vertices);
  EXPECT_TRUE(same.Mesh.Faces == mesh.Faces);
  TriangleMesh book = mesh; // with a third face at an edge
  book.Faces.conservativeResize(mesh.faceCount() + 1, 3);
  book.Faces.row(mesh.faceCount()) << mesh.Faces(0, 0), mesh.Faces(0, 1), mesh.vertexCount() / 2;
  EXPECT_THROW(decimateContext(book, regionsOf(mesh), 1000000), TopologyError);
}

TEST(RegionPreservingDecimation, GivesTheSameBitsEveryTime)
{
  const TriangleMesh mesh = openSphere();
  const DerivedMesh first = decimateContext(mesh, regionsOf(mesh), 700);
  const DerivedMesh second = decimateContext(mesh, regionsOf(mesh), 700);
  EXPECT_TRUE(first.Mesh.Vertices == second.Mesh.Vertices);
  EXPECT_TRUE(first.Mesh.Faces == second.Mesh.Faces);
}

TEST(RegionPreservingDecimation, NamesWhatIsWrong)
{
  TriangleMesh mesh = openSphere();
  const std::vector<char> none(mesh.vertexCount(), 0);
  EXPECT_TRUE(contains(
    messageOf<InvalidInput>([&] { decimateContext(mesh, none, 100); }), "no point is in a region"));
  EXPECT_TRUE(contains(
    messageOf<InvalidInput>([&] { decimateContext(mesh, regionsOf(mesh), 0); }), "positive number"));
  EXPECT_TRUE(contains(messageOf<InvalidInput>(
                         [&] {
                           decimateContext(mesh, { 1, 0 }, 100);
                         }),
    "2 flags"));
  EXPECT_THROW(
    decimateContext(
      mesh, regionsOf(mesh), 100, [](double fraction, const char*) { return fraction < 0.3; }),
    Cancelled);
  const std::vector<char> regions = regionsOf(mesh);
  mesh.Vertices(7, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { decimateContext(mesh, regions, 100); }), "not finite"));
}

} // namespace
