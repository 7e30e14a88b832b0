// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Disk/GeodesicSeam.h"
#include "Geodesics/GeodesicPath.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"

#include <algorithm>
#include <array>
#include <map>

namespace
{

using namespace flattening;
using namespace flattening::samples;

using Points = std::vector<Eigen::Vector3d>;

SeamOpenedSurface seamThrough(const TriangleMesh& mesh, const Points& points, int vertices = 128)
{
  GeodesicSeamOptions options;
  options.Points = points;
  options.BoundaryVertices = vertices;
  return cutGeodesicSeam(mesh, options);
}

Eigen::Vector3d onSphere(double longitude, double latitude)
{
  return { std::cos(longitude) * std::cos(latitude),
    std::sin(longitude) * std::cos(latitude),
    std::sin(latitude) };
}

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double smallestAngleAtSeam(const CutSurface& cut)
{
  const TriangleMesh& mesh = cut.Surface.Mesh;
  double smallest = 180.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d a = mesh.Vertices.row(mesh.Faces(f, k));
      const Eigen::Vector3d u = mesh.Vertices.row(mesh.Faces(f, (k + 1) % 3)).transpose() - a;
      const Eigen::Vector3d v = mesh.Vertices.row(mesh.Faces(f, (k + 2) % 3)).transpose() - a;
      if (cut.OnSeam[mesh.Faces(f, 0)] || cut.OnSeam[mesh.Faces(f, 1)] || cut.OnSeam[mesh.Faces(f, 2)])
      {
        smallest = std::min(smallest, angleBetween(u, v) * 180.0 / Pi);
      }
    }
  }
  return smallest;
}

// The area of all parts of every original face.
Eigen::VectorXd areasOfOriginals(const DerivedMesh& surface, int faceCount)
{
  const Eigen::VectorXd areas = faceAreas(surface.Mesh.Vertices, surface.Mesh.Faces);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(faceCount);
  for (int f = 0; f < surface.Mesh.faceCount(); ++f)
  {
    sums[surface.Faces[f]] += areas[f];
  }
  return sums;
}

TEST(GeodesicPath, OfATubeIsTheStraightLineOfItsNet)
{
  constexpr int n = 48;
  constexpr int m = 40;
  const EditableSurface tube(cylinder(n, m, 3.0));
  using Vertex = SurfaceMesh::Vertex_index;
  const double side = 2.0 * std::sin(Pi / n);
  // Paths across both kinds of diagonals, and along an edge.
  const auto expectStraight = [&](int columns, int row, int otherRow)
  {
    const int from = row * n + 3;
    const int to = otherRow * n + 3 + columns;
    const GeodesicPath path = geodesicPath(tube.mesh(), Vertex(from), Vertex(to));
    EXPECT_NEAR(path.Length, std::hypot(columns * side, (otherRow - row) * 3.0 / m), 1e-12);
    EXPECT_EQ(path.Points.front().Vertex, Vertex(from));
    EXPECT_EQ(path.Points.back().Vertex, Vertex(to));
  };
  expectStraight(14, 5, 28);
  expectStraight(14, 28, 5);
  expectStraight(10, 2, 2);
  expectStraight(1, 7, 7);
}

TEST(GeodesicPath, FromAVertexToItselfIsThatVertex)
{
  const EditableSurface tube(cylinder(12, 4, 1.0));
  const SurfaceMesh::Vertex_index v(20);
  const GeodesicPath path = geodesicPath(tube.mesh(), v, v);
  EXPECT_EQ(path.Length, 0.0);
  ASSERT_EQ(path.Points.size(), 1u);
  EXPECT_EQ(path.Points[0].Vertex, v);
}

TEST(GeodesicPath, CanBeAbortedAtEveryReport)
{
  const EditableSurface tube(cylinder(48, 40, 3.0));
  using Vertex = SurfaceMesh::Vertex_index;
  const Vertex from(5 * 48 + 3);
  const Vertex to(28 * 48 + 17);
  int reports = 0;
  const auto count = [&reports](double, const char*)
  {
    ++reports;
    return true;
  };
  const GeodesicPath path = geodesicPath(tube.mesh(), from, to, count);
  EXPECT_GT(reports, 10) << "the search reports while it works";
  EXPECT_EQ(path.Length, geodesicPath(tube.mesh(), from, to).Length);
  for (int last = 1; last <= reports; ++last)
  {
    int left = last;
    EXPECT_THROW(
      geodesicPath(tube.mesh(), from, to, [&left](double, const char*) { return --left > 0; }),
      Cancelled);
  }
}

TEST(GeodesicSeam, OnASphereIsAnArcOfAGreatCircle)
{
  // The last seam crosses few edges, so the mesh is refined.
  for (const int levels : { 3, 6 })
  {
    const TriangleMesh closed = sphere(levels);
    for (const Points& ends : { Points{ onSphere(0.1, 0.2), onSphere(2.3, -0.4) },
           Points{ onSphere(1.0, -1.0), onSphere(1.2, 0.9) },
           Points{ onSphere(4.0, 0.3), onSphere(4.5, 0.1) } })
    {
      const SeamOpenedSurface opened = seamThrough(closed, ends);
      const Eigen::Vector3d from = opened.Points[0].normalized();
      const Eigen::Vector3d to = opened.Points[1].normalized();
      EXPECT_LT(angleBetween(from, ends[0]), 0.02);
      EXPECT_LT(angleBetween(to, ends[1]), 0.02);
      // Chords are up to 0.3 % shorter than arcs. Along edges it is 3 to 15 % more.
      EXPECT_LT(opened.Length, 1.015 * angleBetween(from, to));
      EXPECT_GT(opened.Length, 0.997 * angleBetween(from, to));
      const Eigen::Vector3d normal = from.cross(to).normalized();
      for (int v = 0; v < opened.Cut.Surface.Mesh.vertexCount(); ++v)
      {
        if (opened.Cut.OnSeam[v])
        {
          EXPECT_LT(std::abs(normal.dot(opened.Cut.Surface.Mesh.Vertices.row(v))), 0.02) << v;
        }
      }
    }
  }
}

TEST(GeodesicSeam, KeepsTheSurfaceAndMakesItADisk)
{
  for (const TriangleMesh& closed : { tetrahedron(), icosahedron(), sphere(3), sphere(5) })
  {
    Points points;
    for (const int f : { 0, 1, 2 })
    {
      points.emplace_back(
        (closed.Vertices.row(closed.Faces(f, 0)) * 0.5 + closed.Vertices.row(closed.Faces(f, 1)) * 0.2 +
          closed.Vertices.row(closed.Faces(f, 2)) * 0.3)
          .transpose());
    }
    const SeamOpenedSurface opened = seamThrough(closed, points);
    const DerivedMesh& surface = opened.Cut.Surface;
    const std::vector<int> boundary = requireDisk(surface.Mesh);
    EXPECT_GE(boundary.size(), 128u);
    double length = 0.0;
    for (std::size_t i = 0; i < boundary.size(); ++i)
    {
      const int v = boundary[i];
      EXPECT_TRUE(opened.Cut.OnSeam[v]);
      length +=
        (surface.Mesh.Vertices.row(v) - surface.Mesh.Vertices.row(boundary[(i + 1) % boundary.size()]))
          .norm();
    }
    EXPECT_NEAR(length, 2.0 * opened.Length, 1e-12 * length);
    const Eigen::VectorXd before = faceAreas(closed.Vertices, closed.Faces);
    const Eigen::VectorXd after = areasOfOriginals(surface, closed.faceCount());
    EXPECT_LT(((after - before).array() / before.array()).abs().maxCoeff(), 1e-11);
    EXPECT_LT((surface.Vertices * closed.Vertices - surface.Mesh.Vertices).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_GT(smallestAngleAtSeam(opened.Cut), 4.0);
  }
}

TEST(GeodesicSeam, BoundaryHasAsManyVerticesAsAskedFor)
{
  const Points points{ onSphere(0.0, 0.0), onSphere(1.0, 0.5) };
  for (const int wanted : { 10, 128, 200 })
  {
    const TriangleMesh mesh = seamThrough(sphere(3), points, wanted).Cut.Surface.Mesh;
    const auto vertices = static_cast<int>(requireDisk(mesh).size());
    EXPECT_GE(vertices, wanted);
    EXPECT_LE(vertices, std::max(60, 4 * wanted));
  }
}

TEST(GeodesicSeam, LengthensTheBoundaryOfAnOpenSurface)
{
  TriangleMesh cap = sphere(4);
  std::vector<int> kept;
  for (int f = 0; f < cap.faceCount(); ++f)
  {
    if (cap.Vertices(cap.Faces(f, 0), 2) > -0.2)
    {
      kept.push_back(f);
    }
  }
  cap = extractFaces(cap, kept).Mesh;
  const std::size_t rim = requireDisk(cap).size();
  const Eigen::Vector3d start = cap.Vertices.row(requireDisk(cap)[5]);
  const Eigen::Vector3d pole(0, 0, 1);
  // Either end of the seam may be at the rim, and the point need not lie on it exactly.
  const Eigen::Vector3d nearStart = (start + Eigen::Vector3d(0, 0, 0.03)).normalized();
  for (const Points& points :
    { Points{ start, pole }, Points{ pole, start }, Points{ nearStart, pole } })
  {
    const SeamOpenedSurface opened = seamThrough(cap, points);
    EXPECT_NEAR(opened.Length, angleBetween(start, pole), 0.01 * angleBetween(start, pole));
    const std::size_t seam =
      (std::size_t(std::count(opened.Cut.OnSeam.begin(), opened.Cut.OnSeam.end(), 1)) - 1) / 2;
    EXPECT_EQ(requireDisk(opened.Cut.Surface.Mesh).size(), rim + 2 * seam);
  }
  EXPECT_TRUE(contains(messageOf<TopologyError>(
                         [&] {
                           seamThrough(cap, { onSphere(0, 0.8), pole });
                         }),
    "neither starts"));
  EXPECT_TRUE(contains(
    messageOf<TopologyError>(
      [&] {
        seamThrough(cap, { start, pole, Eigen::Vector3d(cap.Vertices.row(requireDisk(cap)[40])) });
      }),
    "touches the boundary"));
}

// Halving the edges at a corner of a cube gives the wanted length only up to rounding; refinement must
// end there.
TEST(GeodesicSeam, EdgesMayBeLongerByRounding)
{
  for (int turn = 0; turn < 6; ++turn)
  {
    TriangleMesh corner = tetrahedron();
    const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.1 * turn, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    corner.Vertices *= rotation;
    corner.Vertices.rowwise() += Eigen::RowVector3d::Constant(1000.0); // midpoints are rounded
    const Points ends{ corner.Vertices.row(0), corner.Vertices.row(1) };
    EXPECT_NEAR(seamThrough(corner, ends).Length, 1.0, 1e-9) << turn;
  }
}

TEST(GeodesicSeam, DoesNotDependOnTheUnitAndGivesTheSameTwice)
{
  const TriangleMesh closed = sphere(4);
  const Points points{ onSphere(0.1, 0.2), onSphere(2.3, -0.4), onSphere(2.5, 0.9) };
  const SeamOpenedSurface opened = seamThrough(closed, points);
  for (const double scale : { std::ldexp(1.0, -30), 1.0, std::ldexp(1.0, 30) })
  {
    TriangleMesh scaled = closed;
    scaled.Vertices *= scale;
    Points picked = points;
    for (Eigen::Vector3d& point : picked)
    {
      point *= scale;
    }
    const SeamOpenedSurface other = seamThrough(scaled, picked);
    EXPECT_EQ(other.Cut.Surface.Mesh.Faces, opened.Cut.Surface.Mesh.Faces);
    EXPECT_LT(
      (other.Cut.Surface.Mesh.Vertices / scale - opened.Cut.Surface.Mesh.Vertices).cwiseAbs().maxCoeff(),
      1e-12);
    EXPECT_EQ(other.Cut.OnSeam, opened.Cut.OnSeam);
  }
}

TEST(GeodesicSeam, RejectsPointsThatMakeNoSeam)
{
  const TriangleMesh closed = sphere(4);
  const Eigen::Vector3d a = onSphere(0.0, 0.0);
  const Eigen::Vector3d b = onSphere(1.0, 0.0);
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { seamThrough(closed, {}); }), "0 points"));
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { seamThrough(closed, { a }); }), "1 point "));
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { seamThrough(closed, { a, a }); }), "coincide"));
  const Eigen::Vector3d nearA = a + Eigen::Vector3d(1e-9, 0, 0); // no mesh resolves such a seam
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { seamThrough(closed, { a, nearA }); }), "coincide"));
  EXPECT_TRUE(contains(messageOf<InvalidInput>(
                         [&] {
                           seamThrough(closed, { a, b, b });
                         }),
    "points 2 and 3 of the seam coincide"));
  EXPECT_TRUE(contains(messageOf<TopologyError>(
                         [&] {
                           seamThrough(closed, { a, b, onSphere(0.5, 0.5), a });
                         }),
    "closed"));
  const std::string crossing = messageOf<TopologyError>(
    [&] {
      seamThrough(closed, { a, b, onSphere(0.5, 0.5), onSphere(0.5, -0.5) });
    });
  EXPECT_TRUE(contains(crossing, "crosses") && contains(crossing, "points 3 and 4")) << crossing;
  const std::string off = messageOf<InvalidInput>(
    [&] {
      seamThrough(closed, { a, Eigen::Vector3d(0, 0, 2) });
    });
  EXPECT_TRUE(contains(off, "point 2") && contains(off, "lies 1") && contains(off, "press P")) << off;
  EXPECT_TRUE(contains(messageOf<InvalidInput>(
                         [&] {
                           seamThrough(closed, { a, Eigen::Vector3d(0, NAN, 1) });
                         }),
    "not finite"));
  EXPECT_TRUE(contains(messageOf<TopologyError>(
                         [&] {
                           seamThrough(both(sphere(1), moved(sphere(1), 5, 0, 0)), { a, b });
                         }),
    "2 components"));
  EXPECT_THROW(cutGeodesicSeam(closed, { { a, b }, 128, {} }, [](double, const char*) { return false; }),
    Cancelled);
}

// Three arcs that meet at the pole, in two paths of which the second begins on the first, at one of its
// points or beside its middle.
TEST(GeodesicSeam, SeveralPathsFormATree)
{
  const TriangleMesh closed = sphere(4);
  const Eigen::Vector3d pole = onSphere(0.0, Pi / 2.0);
  const Points first{ onSphere(0.0, 0.5), pole, onSphere(2.0, 0.3) };
  for (const Eigen::Vector3d& start : { pole, Eigen::Vector3d(onSphere(0.0, 1.0)) })
  {
    GeodesicSeamOptions options;
    options.Points = first;
    options.Points.insert(options.Points.end(), { start, onSphere(-2.0, 0.2) });
    options.PathStarts = { 3 };
    const SeamOpenedSurface opened = cutGeodesicSeam(closed, options);
    const TriangleMesh& mesh = opened.Cut.Surface.Mesh;
    const std::vector<int> boundary = requireDisk(mesh);
    const double expected = Pi - 0.8 + angleBetween(start, onSphere(-2.0, 0.2));
    EXPECT_NEAR(opened.Length, expected, 0.03 * expected);
    EXPECT_NEAR(totalArea(mesh), totalArea(closed), 1e-12 * totalArea(closed));
    // Three sectors meet at the junction, and one lies around each end.
    int copies = 0;
    for (const int v : boundary)
    {
      copies += (mesh.Vertices.row(v).transpose() - start).norm() < 0.02 ? 1 : 0;
    }
    EXPECT_GE(copies, 3);
  }
}

TEST(GeodesicSeam, DensePointsGiveTheSeamOfTheirLine)
{
  const TriangleMesh closed = sphere(4);
  GeodesicSeamOptions options;
  for (int i = 0; i <= 2000; ++i)
  {
    options.Points.push_back(onSphere(0.001 * i, 0.2));
  }
  options.AreDense = true;
  std::size_t reportsOfPlacing = 0;
  const auto count = [&reportsOfPlacing](double, const char* stage)
  {
    reportsOfPlacing += std::string(stage) == "placing the seam" ? 1 : 0;
    return true;
  };
  const SeamOpenedSurface opened = cutGeodesicSeam(closed, options, count);
  requireDisk(opened.Cut.Surface.Mesh);
  EXPECT_NEAR(opened.Length, 2.0 * std::cos(0.2), 0.05);
  EXPECT_LT(opened.Points.size(), 60u);
  EXPECT_GT(reportsOfPlacing, opened.Points.size()) << "one for each point";
  EXPECT_GT(smallestAngleAtSeam(opened.Cut), 2.0);
}

TEST(GeodesicSeam, RejectsPathsThatMakeNoTree)
{
  const TriangleMesh closed = sphere(4);
  const Points cross{ onSphere(0, 0), onSphere(1, 0), onSphere(0.5, 0.5), onSphere(0.5, -0.5) };
  const auto rejection = [&closed](const Points& points, const std::vector<int>& starts) {
    return messageOf<TopologyError>([&] { cutGeodesicSeam(closed, { points, 128, starts }); });
  };
  EXPECT_TRUE(contains(rejection(cross, { 2 }), "crosses"));
  EXPECT_TRUE(contains(
    rejection({ cross[0], cross[1], onSphere(3.0, 0), onSphere(4.0, 0) }, { 2 }), "path 2 of the seam"));
  EXPECT_TRUE(contains(
    rejection(
      { cross[0], cross[1], cross[1], onSphere(0.5, 1.0), onSphere(0.5, 1.0), cross[0] }, { 2, 4 }),
    "closes a loop"));
  for (const std::vector<int>& starts : { std::vector<int>{ 1 }, { 3 }, { -1 }, { 9 }, { 2, 2 } })
  {
    EXPECT_TRUE(contains(messageOf<InvalidInput>(
                           [&] {
                             cutGeodesicSeam(closed, { cross, 128, starts });
                           }),
      "a path needs two points"))
      << starts.front();
  }
}

// A face that the seam crosses is in small pieces at the seam and in larger ones away from it.
TEST(GeodesicSeam, RefinesBigFacesNearTheSeamOnly)
{
  const TriangleMesh coarse = sphere(0);
  const SeamOpenedSurface opened =
    seamThrough(coarse, { coarse.Vertices.row(0), coarse.Vertices.row(3) });
  const DerivedMesh& surface = opened.Cut.Surface;
  const double spacing = opened.Length / 64.0;
  std::map<int, std::array<double, 2>> pieces; // per face of the sphere: shortest and longest edge
  for (int f = 0; f < surface.Mesh.faceCount(); ++f)
  {
    auto& [shortest, longest] =
      pieces.try_emplace(surface.Faces[f], std::array{ 9.0, 0.0 }).first->second;
    for (int k = 0; k < 3; ++k)
    {
      const double length = (surface.Mesh.Vertices.row(surface.Mesh.Faces(f, k)) -
                             surface.Mesh.Vertices.row(surface.Mesh.Faces(f, (k + 1) % 3)))
                              .norm();
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
  }
  int crossed = 0;
  for (const auto& [face, lengths] : pieces)
  {
    if (lengths[0] < spacing)
    {
      ++crossed;
      EXPECT_GT(lengths[1], 3.0 * spacing) << face;
    }
  }
  EXPECT_GE(crossed, 2);
}

// A third of the inner equator of a torus, of radius 1.5.
TEST(GeodesicSeam, LeavesHandlesAsTheyAre)
{
  const TriangleMesh ring = torus(90, 30);
  const double third = 2.0 * Pi / 3.0;
  const SeamOpenedSurface opened =
    seamThrough(ring, { { 1.5, 0, 0 }, { 1.5 * std::cos(third), 1.5 * std::sin(third), 0 } });
  EXPECT_NEAR(opened.Length, 1.5 * third, 0.01);
  const TriangleMesh& mesh = opened.Cut.Surface.Mesh;
  const MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
  EXPECT_EQ(topology.Genus, 1);
  ASSERT_EQ(topology.BoundaryLoops.size(), 1u);
  EXPECT_GE(topology.BoundaryLoops[0].size(), 128u);
  EXPECT_NEAR(totalArea(mesh), totalArea(ring), 1e-12 * totalArea(ring));
}

} // namespace
