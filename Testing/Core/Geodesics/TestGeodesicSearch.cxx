// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Geodesics/GeodesicSearch.h"
#include "Support/HubDisk.h"
#include "Support/SampleSurfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace flattening;
using namespace flattening::samples;

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

TriangleMesh flatGrid(int n)
{
  return liftedGrid(n, [](double x, double y) { return Eigen::Vector3d(x, y, 0.0); });
}

// The distances of all vertices from one, exact and without this project's code.
std::vector<double> distancesByCgal(const TriangleMesh& mesh, int source)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  using Paths =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Surface>>;
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    vertices.push_back(
      surface.add_vertex({ mesh.Vertices(v, 0), mesh.Vertices(v, 1), mesh.Vertices(v, 2) }));
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    surface.add_face(vertices[mesh.Faces(f, 0)], vertices[mesh.Faces(f, 1)], vertices[mesh.Faces(f, 2)]);
  }
  Paths paths(surface);
  paths.add_source_point(vertices[source]);
  std::vector<double> distances;
  for (const Surface::Vertex_index v : vertices)
  {
    distances.push_back(paths.shortest_distance_to_source_points(v).first);
  }
  return distances;
}

std::vector<double> allDistances(const TriangleMesh& mesh, int source, Seams seams = Seams::Open)
{
  const UnfoldableFaces faces(mesh, seams);
  GeodesicSearch search(faces);
  std::vector<double> distances(mesh.vertexCount(), Infinite);
  for (const ReachedVertex& reached : search.within(Infinite, source))
  {
    distances[reached.Vertex] = reached.Distance;
  }
  return distances;
}

TEST(GeodesicSearch, StraightInThePlane)
{
  const TriangleMesh mesh = flatGrid(30);
  for (const int source : { 0, 17, 480 })
  {
    const std::vector<double> distances = allDistances(mesh, source);
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      EXPECT_NEAR(distances[v], (mesh.Vertices.row(v) - mesh.Vertices.row(source)).norm(), 1e-13);
    }
  }
}

TEST(GeodesicSearch, StraightOnFoldedPaper)
{
  const TriangleMesh paper = rectangleGrid(25, 25, 1.0);
  TriangleMesh folded = paper;
  for (int v = 0; v < folded.vertexCount(); ++v)
  {
    const double beyond = std::max(paper.Vertices(v, 0), 0.0);
    folded.Vertices(v, 0) -= 0.4 * beyond;
    folded.Vertices(v, 2) += 0.8 * beyond;
  }
  for (const int source : { 3, 80, 311 })
  {
    const std::vector<double> distances = allDistances(folded, source);
    for (int v = 0; v < paper.vertexCount(); ++v)
    {
      EXPECT_NEAR(distances[v], (paper.Vertices.row(v) - paper.Vertices.row(source)).norm(), 1e-13);
    }
  }
}

// The error of the polyhedron against the sphere falls with the square of the edge length.
TEST(GeodesicSearch, GreatCirclesOfTheSphere)
{
  double before = 0.0;
  for (const int levels : { 2, 3, 4 })
  {
    const TriangleMesh mesh = sphere(levels);
    double worst = 0.0;
    for (const int source : { 0, mesh.vertexCount() / 2 })
    {
      const std::vector<double> distances = allDistances(mesh, source);
      for (int v = 0; v < mesh.vertexCount(); ++v)
      {
        const double angle = std::atan2(mesh.Vertices.row(v).cross(mesh.Vertices.row(source)).norm(),
          mesh.Vertices.row(v).dot(mesh.Vertices.row(source)));
        if (v != source)
        {
          EXPECT_LT(distances[v], angle + 1e-12) << "paths over the polyhedron are inside of the sphere";
          worst = std::max(worst, 1.0 - distances[v] / angle);
        }
      }
    }
    EXPECT_LT(worst, 0.25 * std::pow(0.25, levels));
    if (before > 0.0)
    {
      EXPECT_NEAR(worst / before, 0.25, 0.05);
    }
    before = worst;
  }
}

// Ridges and valleys, so that many vertices have more than a full angle, and a hole that paths go
// around.
TriangleMesh ridgesWithAHole()
{
  const TriangleMesh mesh = liftedGrid(20,
    [](double x, double y)
    { return Eigen::Vector3d(x, y, 0.15 * std::sin(9.0 * x) * std::cos(11.0 * y + 3.0 * x)); });
  std::set<int> hole;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const Eigen::RowVector3d centre = faceCorners(mesh, f).colwise().mean();
    if (std::abs(centre.x() - 0.6) < 0.1 && std::abs(centre.y() - 0.4) < 0.2)
    {
      hole.insert(f);
    }
  }
  return withoutFaces(mesh, hole);
}

// The distances on @p mesh, whose first vertices are those of @p open.
void expectDistancesOfCgal(const TriangleMesh& mesh, const TriangleMesh& open)
{
  for (const int source : { 0, 110, 436 })
  {
    const std::vector<double> expected = distancesByCgal(open, source);
    const std::vector<double> distances = allDistances(mesh, source);
    for (int v = 0; v < open.vertexCount(); ++v)
    {
      if (expected[v] >= 0.0) // CGAL's sign of a vertex that no path reaches
      {
        EXPECT_NEAR(distances[v], expected[v], 1e-12) << "from " << source << " to " << v;
      }
      else
      {
        EXPECT_EQ(distances[v], Infinite);
      }
    }
  }
}

TEST(GeodesicSearch, AgreesWithCgal)
{
  const TriangleMesh open = ridgesWithAHole();
  expectDistancesOfCgal(open, open);
}

// A few long edges make the buckets so wide that the rest of a surface lies in one. The search kept all
// windows of a bucket, in the order of their making, and took 4 GB for 8,000 faces.
TEST(GeodesicSearch, ASurfaceInOneBucketAgreesWithCgal)
{
  const TriangleMesh open = ridgesWithAHole();
  TriangleMesh mesh = open;
  const int n = open.vertexCount();
  mesh.Vertices.conservativeResize(n + 3, 3);
  mesh.Vertices.bottomRows(3) << 0, 0, 0, 1e9, 0, 0, 0, 1e9, 0;
  mesh.Faces.conservativeResize(open.faceCount() + 1, 3);
  mesh.Faces.bottomRows(1) << n, n + 1, n + 2;
  expectDistancesOfCgal(mesh, open);
}

Eigen::RowVector3d positionOf(const TriangleMesh& mesh, const PathCrossing& crossing)
{
  if (crossing.Place >= 0)
  {
    return mesh.Vertices.row(crossing.Place);
  }
  const int face = crossing.Halfedge / 3;
  const int corner = crossing.Halfedge % 3;
  return (1.0 - crossing.Fraction) * mesh.Vertices.row(mesh.Faces(face, corner)) +
         crossing.Fraction * mesh.Vertices.row(mesh.Faces(face, (corner + 1) % 3));
}

double lengthOf(const TriangleMesh& mesh, const std::vector<PathCrossing>& path)
{
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    length += (positionOf(mesh, path[i]) - positionOf(mesh, path[i - 1])).norm();
  }
  return length;
}

// A path that crosses a wrong half-edge, or one in a wrong place, has another length.
TEST(GeodesicSearch, PathsAreAsLongAsTheDistances)
{
  const TriangleMesh mesh = ridgesWithAHole();
  const UnfoldableFaces faces(mesh, Seams::Open);
  GeodesicSearch search(faces, Paths::Kept);
  std::size_t crossings = 0;
  for (const int source : { 0, 110, 436 })
  {
    for (const ReachedVertex& reached : search.within(Infinite, source))
    {
      const std::vector<PathCrossing> path = search.pathFrom(reached.Vertex);
      EXPECT_EQ(path.front().Place, reached.Vertex);
      EXPECT_EQ(path.back().Place, source);
      EXPECT_NEAR(lengthOf(mesh, path), reached.Distance, 1e-12) << "from " << source;
      crossings += path.size();
    }
  }
  EXPECT_GT(crossings, 10000u) << "most paths cross many faces";
}

// Loops of edges by which a path does not grow in double precision, as around a speck of a surface.
// CGAL's search, which was used for paths before, ends the program here.
TEST(GeodesicSearch, LoopsShorterThanRoundingDoNoHarm)
{
  const int centre = 300;
  for (const double size : { 1e-14, 1e-17, 1e-30, 1e-200 })
  {
    TriangleMesh mesh = ridgesWithAHole();
    mesh.Vertices.rowwise() -= mesh.Vertices.row(centre).eval(); // the speck lies at the origin
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (mesh.Vertices.row(v).norm() < 0.2)
      {
        mesh.Vertices.row(v) *= size;
      }
    }
    const UnfoldableFaces faces(mesh, Seams::Open);
    GeodesicSearch search(faces, Paths::Kept);
    for (const ReachedVertex& reached : search.within(Infinite, 0))
    {
      EXPECT_NEAR(
        lengthOf(mesh, search.pathFrom(reached.Vertex)), reached.Distance, 1e-12 * reached.Distance);
    }
  }
}

// Some thousand faces that are nearer to each other than rounding: the search takes each of them up a
// few times, whatever the order in which they lie. It once took the last one first, and did not end.
TEST(GeodesicSearch, ASpeckOfManyFacesEnds)
{
  const TriangleMesh flat = flatGrid(60);
  TriangleMesh mesh = flat;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Eigen::RowVector3d out = flat.Vertices.row(v) - Eigen::RowVector3d(0.5, 0.5, 0.0);
    mesh.Vertices.row(v) = std::pow(out.norm(), 20.0) * out; // from 1 to 1e-35 times as large
  }
  const UnfoldableFaces faces(mesh, Seams::Open);
  GeodesicSearch search(faces);
  int checks = 0;
  for (const int source : { 0, 60 * 30 + 30, 59 })
  {
    const std::vector<ReachedVertex> reached =
      search.within(Infinite, source, [&checks] { EXPECT_LT(++checks, 100000); });
    EXPECT_EQ(reached.size(), static_cast<std::size_t>(mesh.vertexCount()));
  }
}

// Needles of a flat map, with a foot of a few roundings of its coordinates: a straight line that comes
// near the tip goes around it a million times, and by rounding comes nearer each time. No shortest path
// does so. The search went on for each time, until there was no more memory.
TEST(GeodesicSearch, NeedlesAreNotGoneAround)
{
  constexpr int sides = 5;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> roundings(-3, 3);
  for (int needle = 0; needle < 100; ++needle)
  {
    TriangleMesh mesh; // the tip, the needle's foot, and a rim around it
    mesh.Vertices.setZero(1 + 2 * sides, 3);
    mesh.Faces.resize(3 * sides, 3);
    mesh.Vertices.row(0) << 0.6 + 3e-10, 0.7 + 2e-10, 0.0;
    for (int k = 0; k < sides; ++k)
    {
      const double angle = 2.0 * EIGEN_PI * k / sides;
      const double x = 0.6 + 1.1e-16 * roundings(random);
      const double y = 0.7 + 1.1e-16 * roundings(random);
      mesh.Vertices.row(1 + k) << x, y, 0.0;
      mesh.Vertices.row(1 + sides + k) << 0.6 + std::cos(angle), 0.7 + std::sin(angle), 0.0;
      const int foot = 1 + k;
      const int nextFoot = 1 + (k + 1) % sides;
      mesh.Faces.row(3 * k) << 0, foot, nextFoot;
      mesh.Faces.row(3 * k + 1) << foot, foot + sides, nextFoot;
      mesh.Faces.row(3 * k + 2) << nextFoot, foot + sides, nextFoot + sides;
    }
    for (const int source : { 0, 1, 1 + sides })
    {
      const std::vector<double> distances = allDistances(mesh, source);
      for (int v = 0; v < mesh.vertexCount(); ++v)
      {
        const double straight = (mesh.Vertices.row(v) - mesh.Vertices.row(source)).norm();
        EXPECT_GE(distances[v], straight - 1e-15) << needle << " " << source << " " << v;
      }
    }
  }
}

TEST(GeodesicSearch, OppositeCornersOfTheCube)
{
  TriangleMesh cube;
  cube.Vertices.resize(8, 3);
  for (int v = 0; v < 8; ++v)
  {
    cube.Vertices.row(v) << v % 2, v / 2 % 2, v / 4;
  }
  cube.Faces.resize(12, 3);
  cube.Faces << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2,
    1, 3, 7, 1, 7, 5;
  const std::vector<double> distances = allDistances(cube, 0);
  EXPECT_NEAR(distances[7], std::sqrt(5.0), 1e-14);
  EXPECT_NEAR(distances[3], std::sqrt(2.0), 1e-14);
}

// A square without its quarter: the path bends at the inner corner.
TEST(GeodesicSearch, BendsAtACornerOfTheBoundary)
{
  const TriangleMesh whole = rectangleGrid(21, 21, 2.0);
  std::set<int> quarter;
  for (int f = 0; f < whole.faceCount(); ++f)
  {
    const Eigen::RowVector3d centre = faceCorners(whole, f).colwise().mean();
    if (centre.x() > 0.0 && centre.y() > 0.0)
    {
      quarter.insert(f);
    }
  }
  const TriangleMesh mesh = withoutFaces(whole, quarter);
  const auto at = [&mesh](double x, double y)
  {
    int v = 0;
    (mesh.Vertices.rowwise() - Eigen::RowVector3d(x, y, 0.0)).rowwise().norm().minCoeff(&v);
    return v;
  };
  const int corner = at(0.0, 0.0);
  const int from = at(-0.4, 0.8);
  const int to = at(1.0, -0.3);
  const auto distance = [&mesh](int a, int b)
  { return (mesh.Vertices.row(a) - mesh.Vertices.row(b)).norm(); };
  EXPECT_NEAR(allDistances(mesh, from)[to], distance(from, corner) + distance(corner, to), 1e-13);
}

// A cylinder of circumference 1 that was cut open. Both banks are copies of one line.
TEST(GeodesicSearch, ClosedSeamsAreCrossed)
{
  const int n = 24;
  TriangleMesh mesh = liftedGrid(n,
    [](double x, double y) -> Eigen::Vector3d
    { return Eigen::Vector3d(std::cos(2 * Pi * x), std::sin(2 * Pi * x), 2 * Pi * y) / (2 * Pi); });
  mesh.Vertices.bottomRows(n + 1) = mesh.Vertices.topRows(n + 1);
  const UnfoldableFaces closed(mesh, Seams::Closed);
  EXPECT_TRUE(closed.HasClosedSeams);
  EXPECT_EQ(closed.placeCount(), n * (n + 1));
  EXPECT_FALSE(UnfoldableFaces(mesh, Seams::Open).HasClosedSeams);

  const int bank = 5;
  const int otherBank = n * (n + 1) + 5;
  const int nearOtherBank = (n - 2) * (n + 1) + 5;
  EXPECT_NEAR(allDistances(mesh, bank)[otherBank], 1.0, 0.01);
  const std::vector<double> distances = allDistances(mesh, bank, Seams::Closed);
  EXPECT_EQ(distances[otherBank], 0.0);
  EXPECT_NEAR(
    distances[nearOtherBank], (mesh.Vertices.row(nearOtherBank) - mesh.Vertices.row(bank)).norm(), 0.01);
  EXPECT_EQ(allDistances(mesh, otherBank, Seams::Closed), distances);
}

TEST(GeodesicSearch, LimitAndTargetsGiveTheSameDistances)
{
  const TriangleMesh mesh =
    liftedGrid(25, [](double x, double y) { return Eigen::Vector3d(x, y, 0.2 * std::sin(9 * x * y)); });
  const std::vector<double> all = allDistances(mesh, 100);
  const UnfoldableFaces faces(mesh, Seams::Open);
  GeodesicSearch search(faces);
  for (const double limit : { 0.0, 0.03, 0.4, 5.0 })
  {
    const std::vector<ReachedVertex> near = search.within(limit, 100);
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [limit](double d) { return d <= limit; }),
      static_cast<long>(near.size()));
    for (const ReachedVertex& reached : near)
    {
      EXPECT_EQ(reached.Distance, all[reached.Vertex]);
    }
  }
  const std::vector<int> targets{ 100, 3, 675, 101 };
  const std::vector<double> distances = search.to(targets, 100);
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    EXPECT_EQ(distances[i], all[targets[i]]);
  }
}

// Faces without area, and copies of one face: distances stay finite, and right where there is a sheet.
TEST(GeodesicSearch, DegenerateFacesDoNoHarm)
{
  TriangleMesh mesh = flatGrid(6);
  const int n = mesh.faceCount();
  mesh.Faces.conservativeResize(n + 4, 3);
  mesh.Faces.row(n) << 0, 0, 1;
  mesh.Faces.row(n + 1) << 5, 5, 5;
  mesh.Faces.row(n + 2) = mesh.Faces.row(20);
  mesh.Faces.row(n + 3) << 0, 7, 14; // three vertices in a line
  const std::vector<double> distances = allDistances(mesh, 0);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double straight = (mesh.Vertices.row(v) - mesh.Vertices.row(0)).norm();
    EXPECT_GT(distances[v], straight - 1e-13);
    EXPECT_LT(distances[v], 1.2 * straight + 1e-13);
  }
}

TEST(GeodesicSearch, AnotherComponentIsNotReached)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(6, 3);
  mesh.Vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0;
  mesh.Faces.resize(2, 3);
  mesh.Faces << 0, 1, 2, 3, 4, 5;
  const UnfoldableFaces faces(mesh, Seams::Closed);
  GeodesicSearch search(faces);
  EXPECT_EQ(search.within(Infinite, 4).size(), 3u);
  EXPECT_EQ(search.to({ 2, 5 }, 1), (std::vector<double>{ std::sqrt(2.0), Infinite }));
}

// Around a vertex of many edges a few buckets, as wide as a mean edge, have hundreds of thousands of
// windows: an abort does not wait for the end of a bucket.
TEST(GeodesicSearch, ChecksWithinABucket)
{
  const TriangleMesh mesh = hubDisk(500, 3);
  const UnfoldableFaces faces(mesh, Seams::Open);
  GeodesicSearch search(faces);
  int checks = 0;
  double farthest = 0.0;
  for (const ReachedVertex& reached : search.within(Infinite, 600, [&checks] { ++checks; }))
  {
    farthest = std::max(farthest, reached.Distance);
  }
  const double buckets = farthest / faces.MeanLength + 1.0;
  EXPECT_LT(buckets, 30.0);
  EXPECT_GT(checks, 2.0 * buckets);
}

TEST(GeodesicSearch, AnEndedSearchCanBeUsedAgain)
{
  const TriangleMesh mesh = flatGrid(20);
  const UnfoldableFaces faces(mesh, Seams::Open);
  GeodesicSearch search(faces);
  int calls = 0;
  EXPECT_THROW(search.within(Infinite,
                 0,
                 [&calls]
                 {
                   if (++calls == 5)
                   {
                     throw Cancelled();
                   }
                 }),
    Cancelled);
  const std::vector<double> expected = allDistances(mesh, 200);
  for (const ReachedVertex& reached : search.within(Infinite, 200))
  {
    EXPECT_EQ(reached.Distance, expected[reached.Vertex]);
  }
}

} // namespace
