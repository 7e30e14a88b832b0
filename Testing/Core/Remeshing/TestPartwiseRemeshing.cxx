// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/IsotropicRemeshing.h"
#include "Remeshing/PartwiseRemeshing.h"
#include "Remeshing/SliverRemoval.h"
#include "Remeshing/SurfaceLayers.h"
#include "Remeshing/SurfaceParts.h"
#include "Support/SampleSurfaces.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

constexpr int PartCount = 3;
constexpr int LargeSphere = 7; // 327680 faces: enough for several parts

std::vector<int> randomParts(int faces)
{
  std::mt19937 random(5);
  std::vector<int> parts(faces);
  for (int& part : parts)
  {
    part = static_cast<int>(random() % PartCount);
  }
  return parts;
}

// The corners of all faces by their positions, sorted: the same for meshes that are numbered
// differently.
std::vector<std::array<double, 9>> facesByPosition(const TriangleMesh& mesh)
{
  std::vector<std::array<double, 9>> faces;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    std::array<std::array<double, 3>, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      const auto p = mesh.Vertices.row(mesh.Faces(f, k));
      corners[k] = { p[0], p[1], p[2] };
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::array<double, 9> face;
    for (int i = 0; i < 9; ++i)
    {
      face[i] = corners[i / 3][i % 3];
    }
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

PlacedMesh placedOn(const SurfaceWithWalk& surface)
{
  return placedOnItself(surface.Walk);
}

// Every face has a part drawn by lot: parts meet themselves in vertices nearly everywhere.
TEST(SurfaceParts, JoinedPartsAreTheSurfaceThatWasCut)
{
  const SurfaceWithWalk surface(sphere(3));
  const PlacedMesh whole = placedOn(surface);
  const auto parts = cutIntoParts(whole, randomParts(whole.Mesh.faceCount()), PartCount);
  int faces = 0;
  for (const SurfacePart& part : parts)
  {
    faces += part.Surface.Mesh.faceCount();
    EXPECT_NO_THROW(analyseTopology(part.Surface.Mesh.Faces, part.Surface.Mesh.vertexCount()));
  }
  EXPECT_EQ(faces, whole.Mesh.faceCount());
  const PlacedMesh joined = joinedParts(parts, whole.Mesh.vertexCount());
  EXPECT_EQ(joined.Mesh.vertexCount(), whole.Mesh.vertexCount());
  EXPECT_EQ(facesByPosition(joined.Mesh), facesByPosition(whole.Mesh));
  for (int v = 0; v < joined.Mesh.vertexCount(); ++v)
  {
    EXPECT_EQ(joined.Places[v].Position.transpose(), joined.Mesh.Vertices.row(v));
  }
}

// The numbers in the whole of the vertices that a part shares, sorted.
std::vector<int> sharedVertices(const SurfacePart& part)
{
  std::vector<int> shared;
  for (const int v : part.Shared)
  {
    if (v >= 0)
    {
      shared.push_back(v);
    }
  }
  std::sort(shared.begin(), shared.end());
  return shared;
}

// Bands of the surface, in which every thirtieth face belongs to a part drawn by lot.
std::vector<int> raggedBands(const TriangleMesh& mesh)
{
  std::vector<int> parts = randomParts(mesh.faceCount());
  const std::vector<int> levels = levelsOfFaces(mesh);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    parts[f] = f % 30 == 0 ? parts[f] : levels[f] / 8 % PartCount;
  }
  return parts;
}

TriangleMesh remeshedInParts(const TriangleMesh& mesh, const std::vector<int>& partOfFace, double length)
{
  const auto surface = std::make_shared<const SurfaceWithWalk>(mesh);
  const std::shared_ptr<const ClosestPointWalk> walk(surface, &surface->Walk);
  std::vector<SurfacePart> parts = cutIntoParts(placedOn(*surface), partOfFace, PartCount);
  for (SurfacePart& part : parts)
  {
    MeshOnSurface onSurface(walk, part.Surface, part.Kept);
    IsotropicRemesher remesher(onSurface, length, { 1000000 });
    remesher.iterate({});
    remesher.iterate({});
    part = remeshedPart(part, onSurface);
  }
  return joinedParts(parts, mesh.vertexCount()).Mesh;
}

TEST(SurfaceParts, RemeshedPartsFitTogether)
{
  const TriangleMesh mesh = sphere(5);
  for (const double factor : { 0.3, 1.0, 3.0 })
  {
    for (const auto& parts : { raggedBands(mesh), randomParts(mesh.faceCount()) })
    {
      const TriangleMesh joined = remeshedInParts(mesh, parts, factor * meanEdgeLength(mesh));
      const MeshTopology topology = analyseTopology(joined.Faces, joined.vertexCount());
      EXPECT_EQ(topology.Vertices, joined.vertexCount());
      EXPECT_EQ(topology.eulerCharacteristic(), 2) << factor;
      EXPECT_TRUE(topology.BoundaryLoops.empty()) << factor;
      EXPECT_NEAR(totalArea(joined) / totalArea(mesh), 1.0, 0.01) << factor;
    }
  }
}

TEST(SurfaceParts, TheInsideOfPartsIsRemeshed)
{
  const TriangleMesh mesh = sphere(5);
  const double length = meanEdgeLength(mesh);
  const int vertices = mesh.vertexCount();
  EXPECT_GT(remeshedInParts(mesh, raggedBands(mesh), 0.3 * length).vertexCount(), 4 * vertices);
  EXPECT_LT(remeshedInParts(mesh, raggedBands(mesh), 3.0 * length).vertexCount(), vertices / 2);
}

// Two opposite thirds of a fan around vertex 0 are a part that meets itself there: it has two vertices
// for that one, and nothing around them may change, although no other part has the vertices 2 and 8.
TEST(SurfaceParts, WherePartsMeetThemselvesAllVerticesAreKept)
{
  TriangleMesh fan;
  fan.Vertices = Points3::Zero(13, 3);
  fan.Faces.resize(12, 3);
  std::vector<int> part;
  for (int k = 0; k < 12; ++k)
  {
    fan.Vertices.row(1 + k) << std::cos(Pi / 6 * k), std::sin(Pi / 6 * k), 0.0;
    fan.Faces.row(k) << 0, 1 + k, 1 + (k + 1) % 12;
    part.push_back(k % 6 < 2 ? 0 : 1);
  }
  const SurfaceWithWalk surface(fan);
  const auto parts = cutIntoParts(placedOn(surface), part, 2);
  EXPECT_EQ(parts[0].Surface.Mesh.vertexCount(), 8); // 1 to 3, 7 to 9, and vertex 0 twice
  EXPECT_EQ(std::count(parts[0].Shared.begin(), parts[0].Shared.end(), 0), 2);
  EXPECT_EQ(std::count(parts[0].Shared.begin(), parts[0].Shared.end(), -1), 2); // 2 and 8
  EXPECT_EQ(std::count(parts[0].Kept.begin(), parts[0].Kept.end(), 1), 8);
}

// Each part has the vertices that it shares with others where they were, however it is remeshed.
TEST(SurfaceParts, SharedVerticesStay)
{
  const TriangleMesh mesh = sphere(4);
  const auto surface = std::make_shared<const SurfaceWithWalk>(mesh);
  for (const double factor : { 0.5, 2.0 })
  {
    for (const SurfacePart& part : cutIntoParts(placedOn(*surface), raggedBands(mesh), PartCount))
    {
      MeshOnSurface onSurface({ surface, &surface->Walk }, part.Surface, part.Kept);
      IsotropicRemesher remesher(onSurface, factor * meanEdgeLength(mesh), { 1000000 });
      remesher.iterate({});
      const SurfacePart remeshed = remeshedPart(part, onSurface);
      EXPECT_EQ(sharedVertices(remeshed), sharedVertices(part));
      for (std::size_t v = 0; v < remeshed.Shared.size(); ++v)
      {
        if (remeshed.Shared[v] >= 0)
        {
          EXPECT_EQ(remeshed.Surface.Mesh.Vertices.row(static_cast<Eigen::Index>(v)),
            mesh.Vertices.row(remeshed.Shared[v]));
        }
      }
    }
  }
}

// A strip of long triangles: an edge that must stay is the longest of flat faces, the others of which
// cannot be made short.
TEST(SurfaceParts, SplittingBesideALongKeptEdgeEnds)
{
  TriangleMesh mesh = rectangleGrid(3, 200, 1e-3);
  const auto surface = std::make_shared<const SurfaceWithWalk>(mesh);
  PlacedMesh present = placedOn(*surface);
  std::vector<char> kept(mesh.vertexCount(), 0);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    kept[v] = static_cast<char>(v % 4 == 0 || v % 5 == 0);
  }
  MeshOnSurface onSurface({ surface, &surface->Walk }, present, kept);
  IsotropicRemesher remesher(onSurface, 1e-2 * meanEdgeLength(mesh), { 1000000 });
  EXPECT_NO_THROW(remesher.iterate({}));
}

TEST(SurfaceLayers, LevelsCountTheEdgesFromOneEnd)
{
  // The first vertex of the strip is in a corner, the end that is farthest from it on the other side.
  const TriangleMesh strip = rectangleGrid(2, 11, 1.0);
  const std::vector<int> levels = levelsOfFaces(strip);
  EXPECT_EQ(*std::min_element(levels.begin(), levels.end()), 0);
  EXPECT_EQ(*std::max_element(levels.begin(), levels.end()), 10); // the strip's length
  const std::vector<int> begins = firstLevels(levels, 4);
  ASSERT_EQ(begins.size(), 3u);
  for (int i = 0; i < 3; ++i)
  {
    const long below = std::count_if(
      levels.begin(), levels.end(), [begin = begins[i]](int level) { return level < begin; });
    EXPECT_NEAR(below, (i + 1) * strip.faceCount() / 4.0, 2.0);
  }
}

TEST(PartwiseRemeshing, SmallSurfacesAreRemeshedAsAWhole)
{
  const auto surface = std::make_shared<const SurfaceWithWalk>(sphere(4));
  EXPECT_FALSE(remeshedInParts(surface, 0.1, { 1000000 }, 3, {}));
}

TEST(PartwiseRemeshing, TheTrianglesAreAsGoodAsThoseOfTheWhole)
{
  const TriangleMesh input = sphere(LargeSphere);
  const double length = 1.5 * meanEdgeLength(input);
  const auto surface = std::make_shared<const SurfaceWithWalk>(input);
  ASSERT_TRUE(remeshedInParts(surface, length, { 1000000 }, 3, {}));
  const DerivedMesh remeshed = remeshIsotropically(input, length);
  EXPECT_EQ(analyseTopology(remeshed.Mesh.Faces, remeshed.Mesh.vertexCount()).eulerCharacteristic(), 2);
  EXPECT_GT(smallestAngle(remeshed.Mesh), 15.0);
  EXPECT_NEAR(meanEdgeLength(remeshed.Mesh) / length, 1.0, 0.1);
  EXPECT_NEAR(totalArea(remeshed.Mesh) / totalArea(input), 1.0, 1e-3);
  const Points3 traced = remeshed.Vertices * input.Vertices;
  EXPECT_LT((traced - remeshed.Mesh.Vertices).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PartwiseRemeshing, TheNumberOfThreadsDoesNotMatter)
{
  const TriangleMesh input = sphere(LargeSphere);
  const double length = 4.0 * meanEdgeLength(input);
  const DerivedMesh parallel = remeshIsotropically(input, length, 2);
  const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
  const DerivedMesh serial = remeshIsotropically(input, length, 2);
  EXPECT_EQ(parallel.Mesh.Vertices, serial.Mesh.Vertices);
  EXPECT_EQ(parallel.Mesh.Faces, serial.Mesh.Faces);
  EXPECT_EQ(parallel.Faces, serial.Faces);
}

TEST(PartwiseRemeshing, AnAbortIsNoticedAndProgressNeverFalls)
{
  const TriangleMesh input = sphere(LargeSphere);
  double last = 0.0;
  const auto abort = [&last](double fraction, const char*)
  {
    EXPECT_GE(fraction, last);
    last = fraction;
    return fraction < 0.1;
  };
  EXPECT_THROW(remeshIsotropically(input, meanEdgeLength(input), 3, abort), Cancelled);
  EXPECT_LT(last, 0.7);
}

} // namespace
