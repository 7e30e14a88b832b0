// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/MeshTopology.h"

#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

using Factors = IntrinsicTriangulation::Factors;

double length(const IntrinsicTriangulation& t, int h)
{
  return std::exp(static_cast<double>(t.logLength(h)));
}

TriangleAngles anglesOf(const IntrinsicTriangulation& t, int f)
{
  return triangleAngles(t.logLength(3 * f), t.logLength(3 * f + 1), t.logLength(3 * f + 2));
}

double area(const IntrinsicTriangulation& t)
{
  double sum = 0.0;
  for (int f = 0; f < t.faceCount(); ++f)
  {
    sum += 0.5 * length(t, 3 * f) * length(t, 3 * f + 1) * std::sin(anglesOf(t, f).Angle[2]);
  }
  return sum;
}

Eigen::VectorXd angleSums(const IntrinsicTriangulation& t)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(t.vertexCount());
  for (int f = 0; f < t.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      sums[t.origin(IntrinsicTriangulation::previous(3 * f + k))] += anglesOf(t, f).Angle[k];
    }
  }
  return sums;
}

void expectConsistent(const IntrinsicTriangulation& t)
{
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    const int twin = t.twin(h);
    if (twin >= 0)
    {
      ASSERT_EQ(t.twin(twin), h);
      ASSERT_EQ(t.origin(twin), t.tip(h));
      ASSERT_EQ(t.tip(twin), t.origin(h));
      ASSERT_EQ(t.logLength(twin), t.logLength(h));
    }
    else
    {
      ASSERT_EQ(t.boundaryEdges()[-1 - twin].Inner, h);
    }
  }
  for (int b = 0; b < static_cast<int>(t.boundaryEdges().size()); ++b)
  {
    const auto& edge = t.boundaryEdges()[b];
    if (edge.Origin < 0)
    {
      continue;
    }
    ASSERT_EQ(t.boundaryEdges()[edge.Previous].Next, b);
    ASSERT_EQ(t.boundaryEdges()[edge.Next].Previous, b);
    if (edge.Inner >= 0)
    {
      ASSERT_EQ(t.twin(edge.Inner), -1 - b);
      ASSERT_EQ(t.origin(edge.Inner), edge.Origin);
      ASSERT_EQ(t.tip(edge.Inner), t.tipOfBoundaryEdge(b));
      ASSERT_EQ(t.logLength(edge.Inner), edge.LogLength);
    }
    else
    {
      const auto& other = t.boundaryEdges()[-1 - edge.Inner];
      ASSERT_EQ(other.Inner, -1 - b);
      ASSERT_EQ(other.Origin, t.tipOfBoundaryEdge(b));
      ASSERT_EQ(other.LogLength, edge.LogLength);
    }
  }
}

// Requires that no edge has opposite angles whose sum exceeds pi.
void expectDelaunay(const IntrinsicTriangulation& t, const Factors& u)
{
  const auto opposite = [&](int h)
  {
    return triangleAngles(t.scaledLogLength(h, u),
      t.scaledLogLength(IntrinsicTriangulation::next(h), u),
      t.scaledLogLength(IntrinsicTriangulation::previous(h), u))
      .Angle[0];
  };
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    if (t.twin(h) >= 0)
    {
      ASSERT_LE(opposite(h) + opposite(t.twin(h)), EIGEN_PI + 1e-5) << h;
    }
  }
}

// The disk's rings, squeezed along y: flat, with many triangles that are not Delaunay.
TriangleMesh squeezedDisk(int vertexCount, double factor)
{
  TriangleMesh mesh = ringMesh(flatDisk(), vertexCount).Mesh;
  mesh.Vertices.col(1) *= factor;
  return mesh;
}

TEST(IntrinsicTriangulation, FlippedPlanarMeshIsItsDelaunayTriangulation)
{
  const TriangleMesh mesh = squeezedDisk(1500, 0.15);
  IntrinsicTriangulation t(mesh);
  EXPECT_EQ(t.addedLength(), 0.0);
  const Eigen::VectorXd before = angleSums(t);
  EXPECT_GT(t.flipToDelaunay(), 1000);
  expectConsistent(t);
  expectDelaunay(t, Factors::Zero(t.vertexCount()));
  EXPECT_LT((angleSums(t) - before).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_NEAR(area(t), faceAreas(mesh.Vertices, mesh.Faces).sum(), 1e-13);
  // In the plane an intrinsic edge is straight: its length is the distance of its ends, and no other
  // vertex lies in a triangle's circle.
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    const double distance = (mesh.Vertices.row(t.origin(h)) - mesh.Vertices.row(t.tip(h))).norm();
    ASSERT_NEAR(length(t, h) / distance, 1.0, 1e-12);
  }
  for (int f = 0; f < t.faceCount(); f += 37)
  {
    const Eigen::RowVector2d a = mesh.Vertices.row(t.origin(3 * f)).head<2>();
    const Eigen::RowVector2d b = mesh.Vertices.row(t.origin(3 * f + 1)).head<2>();
    const Eigen::RowVector2d c = mesh.Vertices.row(t.origin(3 * f + 2)).head<2>();
    Eigen::Matrix2d sides;
    sides << b - a, c - a;
    const Eigen::Vector2d right(0.5 * (b - a).squaredNorm(), 0.5 * (c - a).squaredNorm());
    const Eigen::RowVector2d radius = (sides.inverse() * right).transpose();
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      ASSERT_GE((mesh.Vertices.row(v).head<2>() - a - radius).norm(), radius.norm() * (1.0 - 1e-6));
    }
  }
}

TEST(IntrinsicTriangulation, FlipsOnACurvedSurfaceKeepItsMetric)
{
  TriangleMesh mesh = sunflowerMesh(gaussianBump(2.0, 0.3), 2000).Mesh;
  mesh.Vertices.col(0) *= 4.0;
  IntrinsicTriangulation t(mesh);
  const Eigen::VectorXd before = angleSums(t);
  EXPECT_GT(t.flipToDelaunay(), 500);
  expectConsistent(t);
  expectDelaunay(t, Factors::Zero(t.vertexCount()));
  EXPECT_LT((angleSums(t) - before).cwiseAbs().maxCoeff(), 1e-10) << "curvature moved";
  EXPECT_NEAR(area(t) / faceAreas(mesh.Vertices, mesh.Faces).sum(), 1.0, 1e-12);
  EXPECT_EQ(t.flipToDelaunay(), 0) << "is Delaunay already";
}

TEST(IntrinsicTriangulation, APartIsFlippedAlone)
{
  TriangleMesh mesh = sunflowerMesh(gaussianBump(2.0, 0.3), 2000).Mesh;
  mesh.Vertices.col(0) *= 4.0;
  IntrinsicTriangulation t(mesh);
  const Eigen::VectorXd before = angleSums(t);
  std::vector<int> faces;
  for (int f = 0; f < t.faceCount(); ++f)
  {
    if (mesh.Vertices(mesh.Faces(f, 0), 0) > 0.5)
    {
      faces.push_back(f);
    }
  }
  IntrinsicTriangulation::Part part = t.part(faces);
  EXPECT_LT(part.Triangulation.vertexCount(), t.vertexCount() / 2);
  const Factors none = Factors::Zero(part.Triangulation.vertexCount());
  const int flips = part.Triangulation.flipToDelaunay(none);
  EXPECT_GT(flips, 100);
  expectDelaunay(part.Triangulation, none);
  t.replace(part);
  expectConsistent(t);
  EXPECT_EQ(t.part(faces).Triangulation.flipToDelaunay(none), 0) << "the part's flips are here";
  EXPECT_GT(t.flipToDelaunay(Factors::Zero(t.vertexCount())), 100) << "none were made elsewhere";
  // Flips by Ptolemy's relation change the curvature; vertices away from all flips keep theirs.
  std::vector<char> inPart(t.vertexCount(), 0);
  for (const int v : part.Vertices)
  {
    inPart[v] = 1;
  }
  IntrinsicTriangulation only(mesh);
  only.replace(part);
  const Eigen::VectorXd after = angleSums(only);
  for (int v = 0; v < t.vertexCount(); ++v)
  {
    if (!inPart[v])
    {
      ASSERT_EQ(after[v], before[v]);
    }
  }
}

// The length cross ratios of all edges define a discrete conformal class. Ptolemy's relation tells how a
// flip changes lengths within the class: flips there and back restore all lengths.
TEST(IntrinsicTriangulation, PtolemaicFlipsKeepTheConformalClass)
{
  const TriangleMesh mesh = sunflowerMesh(gaussianBump(0.5, 0.3), 1000).Mesh;
  IntrinsicTriangulation t(mesh);
  t.flipToDelaunay();
  const IntrinsicTriangulation original = t;
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.0, 1.5);
  Factors u(t.vertexCount());
  for (Eigen::Index v = 0; v < u.size(); ++v)
  {
    u[v] = normal(random);
  }
  EXPECT_GT(t.flipToDelaunay(u), 100);
  expectConsistent(t);
  // With the mirror image, Delaunay at u means proper triangles at u, and proper mirror cells.
  for (int f = 0; f < t.faceCount(); ++f)
  {
    EXPECT_FALSE(t.scaledAngles(f, u).Degenerate) << f;
  }
  int crossings = 0;
  for (int b = 0; b < static_cast<int>(t.boundaryEdges().size()); ++b)
  {
    if (t.boundaryEdges()[b].Origin >= 0)
    {
      EXPECT_FALSE(trapezoidShape(t.scaledTrapezoid(b, u)).Degenerate) << b;
      crossings += std::isfinite(t.boundaryEdges()[b].LogCrossing);
    }
  }
  EXPECT_GT(crossings, 10);
  EXPECT_GT(t.flipToDelaunay(Factors::Zero(u.size())), 100);
  expectConsistent(t);
  // The Delaunay triangulation of the mesh's own metric is unique: the same edges, the same lengths.
  const auto edges = [](const IntrinsicTriangulation& t)
  {
    std::vector<std::pair<std::pair<int, int>, double>> list;
    for (int h = 0; h < t.halfedgeCount(); ++h)
    {
      list.push_back({ { t.origin(h), t.tip(h) }, length(t, h) });
    }
    std::sort(list.begin(), list.end());
    return list;
  };
  const auto expected = edges(original);
  const auto found = edges(t);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t e = 0; e < found.size(); ++e)
  {
    EXPECT_EQ(found[e].first, expected[e].first);
    EXPECT_NEAR(found[e].second / expected[e].second, 1.0, 1e-12);
  }
}

// The surface and its mirror image as one closed mesh: image of vertex v is v itself on the boundary.
TriangleMesh doubled(const TriangleMesh& mesh)
{
  std::vector<int> image(mesh.vertexCount(), -1);
  for (const int v : requireDisk(mesh))
  {
    image[v] = v;
  }
  TriangleMesh both = mesh;
  both.Vertices.conservativeResize(2 * mesh.vertexCount(), 3);
  both.Vertices.bottomRows(mesh.vertexCount()) = mesh.Vertices;
  both.Faces.conservativeResize(2 * mesh.faceCount(), 3);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = mesh.Faces(f, 2 - k);
      both.Faces(mesh.faceCount() + f, k) = image[v] >= 0 ? v : mesh.vertexCount() + v;
    }
  }
  return both;
}

// Mirror cells represent the Delaunay triangulation of the closed double, where a boundary edge is
// flipped like any other edge.
TEST(IntrinsicTriangulation, MirrorCellsAreHalfOfTheDouble)
{
  for (const double spread : { 0.3, 2.0, 6.0 })
  {
    SCOPED_TRACE(spread);
    const TriangleMesh mesh = sunflowerMesh(gaussianBump(0.5, 0.3), 300).Mesh;
    const int n = mesh.vertexCount();
    IntrinsicTriangulation half(mesh);
    IntrinsicTriangulation whole(doubled(mesh));
    std::mt19937 random(11);
    std::normal_distribution<double> normal(0.0, spread);
    Factors u(n);
    for (int v = 0; v < n; ++v)
    {
      u[v] = normal(random);
    }
    Factors twice(2 * n);
    twice << u, u;
    half.flipToDelaunay(u);
    whole.flipToDelaunay(twice);
    expectConsistent(half);
    expectDelaunay(half, u);
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(n);
    for (int f = 0; f < whole.faceCount(); ++f)
    {
      const TriangleAngles angles = whole.scaledAngles(f, twice);
      ASSERT_FALSE(angles.Degenerate);
      for (int k = 0; k < 3; ++k)
      {
        expected[whole.origin(whole.previous(3 * f + k)) % n] += 0.5 * angles.Angle[k];
      }
    }
    // An inner vertex and its image have the same angles: half of the sum is one vertex's.
    Eigen::VectorXd found = Eigen::VectorXd::Zero(n);
    for (int f = 0; f < half.faceCount(); ++f)
    {
      const TriangleAngles angles = half.scaledAngles(f, u);
      for (int k = 0; k < 3; ++k)
      {
        found[half.origin(half.previous(3 * f + k))] += angles.Angle[k];
      }
    }
    int crossings = 0;
    for (int b = 0; b < static_cast<int>(half.boundaryEdges().size()); ++b)
    {
      if (half.boundaryEdges()[b].Origin >= 0)
      {
        const TrapezoidShape cell = trapezoidShape(half.scaledTrapezoid(b, u));
        found[half.boundaryEdges()[b].Origin] += cell.AngleAtOrigin;
        found[half.tipOfBoundaryEdge(b)] += cell.AngleAtTip;
        crossings += std::isfinite(half.boundaryEdges()[b].LogCrossing);
      }
    }
    EXPECT_GT(crossings, 0);
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-9);

    // There and back: all vertices leave the mirror again, and lengths are what they were.
    half.flipToDelaunay(Factors::Zero(n));
    IntrinsicTriangulation fresh(mesh);
    fresh.flipToDelaunay(Factors::Zero(n));
    expectConsistent(half);
    EXPECT_LT((angleSums(half) - angleSums(fresh)).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(area(half) / area(fresh), 1.0, 1e-12);
  }
}

TEST(IntrinsicTriangulation, RemovedStarLeavesTheRestAndNamesTheLink)
{
  const RevolutionMesh disk = ringMesh(sphericalCap(1.0), 300);
  IntrinsicTriangulation t(disk.Mesh);
  const double whole = area(t);
  double star = 0.0;
  std::vector<int> around;
  const int vertex = disk.FirstBoundaryVertex + 4;
  for (int h : t.outgoing(vertex))
  {
    const int f = IntrinsicTriangulation::face(h);
    star += 0.5 * length(t, 3 * f) * length(t, 3 * f + 1) * std::sin(anglesOf(t, f).Angle[2]);
    around.push_back(t.tip(h));
  }
  ASSERT_GE(around.size(), 2u);
  const auto removed = t.removeStar(vertex);
  ASSERT_EQ(removed.Spokes.size(), around.size() + 1);
  EXPECT_EQ(removed.Spokes.front().Vertex, vertex + 1);
  EXPECT_EQ(removed.Spokes.back().Vertex, vertex - 1);
  for (std::size_t k = 0; k < removed.Spokes.size(); ++k)
  {
    const int other = removed.Spokes[k].Vertex;
    EXPECT_TRUE(k == around.size() || other == around[k]);
    EXPECT_NEAR(std::exp(static_cast<double>(removed.Spokes[k].LogLength)),
      (disk.Mesh.Vertices.row(vertex) - disk.Mesh.Vertices.row(other)).norm(),
      1e-15);
  }
  EXPECT_NEAR(area(t), whole - star, 1e-13);
  EXPECT_EQ(t.faceCount(), disk.Mesh.faceCount() - static_cast<int>(around.size()));
  expectConsistent(t);
  // Around the boundary: the rest of the mirror, then the edges at infinity, back to front.
  int b = removed.FirstBoundaryEdge;
  for (int v = vertex + 1; !t.boundaryEdges()[b].AtInfinity; b = t.boundaryEdges()[b].Next)
  {
    EXPECT_EQ(t.boundaryEdges()[b].Origin, v);
    v = v + 1 < disk.Mesh.vertexCount() ? v + 1 : disk.FirstBoundaryVertex;
  }
  for (std::size_t k = around.size(); k > 0; --k, b = t.boundaryEdges()[b].Next)
  {
    EXPECT_TRUE(t.boundaryEdges()[b].AtInfinity);
    EXPECT_EQ(t.boundaryEdges()[b].Origin, removed.Spokes[k].Vertex);
  }
  EXPECT_EQ(b, removed.FirstBoundaryEdge);
}

TEST(IntrinsicTriangulation, DegenerateFacesAreOpened)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(4, 3);
  mesh.Vertices << 0, 0, 0, 2, 0, 0, 1, 0, 0, 1, 1, 0; // 2 lies on the side 0 1
  mesh.Faces.resize(3, 3);
  mesh.Faces << 0, 1, 2, 1, 3, 2, 0, 2, 3;
  const IntrinsicTriangulation t(mesh);
  EXPECT_GT(t.addedLength(), 0.0);
  EXPECT_LT(t.addedLength(), 1e-9);
  for (int f = 0; f < 3; ++f)
  {
    EXPECT_FALSE(anglesOf(t, f).Degenerate);
  }
}

TEST(TriangleAngles, LawOfCosines)
{
  const double sides[][3] = { { 3, 4, 5 }, { 1, 1, 1 }, { 2, 3, 4.5 }, { 7, 7, 1 }, { 1, 1.2, 2.1 } };
  for (const auto& s : sides)
  {
    const TriangleAngles t = triangleAngles(
      std::log((long double)s[0]), std::log((long double)s[1]), std::log((long double)s[2]));
    ASSERT_FALSE(t.Degenerate);
    for (int k = 0; k < 3; ++k)
    {
      const double b = s[(k + 1) % 3];
      const double c = s[(k + 2) % 3];
      const double angle = std::acos((b * b + c * c - s[k] * s[k]) / (2 * b * c));
      EXPECT_NEAR(t.Angle[k], angle, 1e-14);
      EXPECT_NEAR(t.Cotangent[k], 1.0 / std::tan(angle), 1e-13);
    }
  }
}

// A needle with two sides of nearly the same length: to first order the small angles follow from the
// exact differences of the logarithms, of which sides in double would keep no digit.
TEST(TriangleAngles, NeedlesKeepTheirDigits)
{
  // Sides 1, 1 + d and w: w^2 = d^2 + 4 (1 + d) sin(alpha / 2)^2 gives the angle between the long ones.
  for (const long double w : { 1e-4L, 1e-8L, 1e-12L })
  {
    const long double d = 0.6L * w;
    const TriangleAngles t = triangleAngles(std::log(w), 0.0L, std::log1p(d));
    ASSERT_FALSE(t.Degenerate);
    const long double sine = std::sqrt((w - d) * (w + d) / (4.0L * (1.0L + d)));
    EXPECT_NEAR(t.Angle[0] / static_cast<double>(2.0L * std::asin(sine)), 1.0, 1e-7)
      << static_cast<double>(w);
    EXPECT_NEAR(t.Angle[0] + t.Angle[1] + t.Angle[2], EIGEN_PI, 1e-15);
    EXPECT_NEAR(t.Cotangent[0] * std::tan(t.Angle[0]), 1.0, 1e-7);
  }
}

TEST(TriangleAngles, BrokenInequalityIsTheFlatTriangle)
{
  for (const double excess : { 1.0001, 5.0 })
  {
    const TriangleAngles t = triangleAngles(std::log(1.0L), std::log(3.0L * excess), std::log(2.0L));
    EXPECT_TRUE(t.Degenerate);
    EXPECT_EQ(t.Angle[0], 0.0);
    EXPECT_EQ(t.Angle[1], static_cast<double>(EIGEN_PI));
    EXPECT_EQ(t.Angle[2], 0.0);
    EXPECT_EQ(t.Cotangent[0], 0.0);
  }
}

// Scaling all sides changes no angle, however large the factor.
TEST(TriangleAngles, OnlyShapeCounts)
{
  const TriangleAngles expected = triangleAngles(std::log(2.0L), std::log(3.0L), std::log(4.0L));
  for (const long double shift : { -4000.0L, 4000.0L })
  {
    const TriangleAngles t =
      triangleAngles(std::log(2.0L) + shift, std::log(3.0L) + shift, std::log(4.0L) + shift);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(t.Angle[k], expected.Angle[k], 1e-14);
    }
  }
}

} // namespace
