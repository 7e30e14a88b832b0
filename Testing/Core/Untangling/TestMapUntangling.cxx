// SPDX-License-Identifier: GPL-3.0-or-later
/// Flat maps with flipped faces made by hand.
#include "AnalyticSurfaces.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"
#include "Support/AbandonedCall.h"
#include "Support/RandomNumbers.h"
#include "Untangling/MapUntangling.h"
#include "Untangling/PatchUntangling.h"
#include "Untangling/TargetTriangles.h"

#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;

// A disk of 1,000 vertices in hexagonal rings about vertex 0: its own perfect map.
TriangleMesh ringDisk()
{
  return ringMesh(flatDisk(), 1000).Mesh;
}

Points2 planar(const TriangleMesh& mesh)
{
  return mesh.Vertices.leftCols<2>();
}

// The part within the radius is rotated by an angle (radians).
Points2 twisted(const TriangleMesh& mesh, double radius, double angle)
{
  Points2 positions = planar(mesh);
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (positions.row(v).norm() < radius)
    {
      positions.row(v) = (positions.row(v) * turn.transpose()).eval();
    }
  }
  return positions;
}

std::vector<int> movedVertices(const Points2& before, const Points2& after)
{
  std::vector<int> moved;
  for (int v = 0; v < before.rows(); ++v)
  {
    if (before.row(v) != after.row(v))
    {
      moved.push_back(v);
    }
  }
  return moved;
}

// One vertex lies beyond the opposite side of one of its faces: it alone moves, and not farther than
// back.
TEST(MapUntangling, MovesOneVertexIfThatIsEnough)
{
  const TriangleMesh mesh = ringDisk();
  const Points2 perfect = planar(mesh);
  Points2 positions = perfect;
  const double edge = (perfect.row(1) - perfect.row(0)).norm();
  positions.row(0) += 1.1 * (perfect.row(1) - perfect.row(0));
  const Points2 before = positions;
  ASSERT_EQ(countFlippedFaces(positions, mesh.Faces), 2);
  const UntanglingReport report = untangleMap(mesh, requireDisk(mesh), positions);
  EXPECT_EQ(countFlippedFaces(positions, mesh.Faces), 0);
  EXPECT_EQ(report.RepairedFaces, 2);
  EXPECT_EQ(report.FlippedFaces, 0);
  EXPECT_EQ(report.MovedVertices, 1);
  EXPECT_EQ(movedVertices(before, positions).size(), 1u);
  EXPECT_GT(report.GreatestMove, 0.1);
  EXPECT_LT((positions - before).rowwise().norm().maxCoeff(), 1.1 * edge);
}

class Twist : public testing::TestWithParam<double>
{
};

// The inner rings are rotated against the next ring, anywhere in the plane and at any scale: only the
// vertices near the twist move.
TEST_P(Twist, IsUndoneWhereItIs)
{
  const double size = GetParam();
  const TriangleMesh mesh = ringDisk();
  const double ring = (mesh.Vertices.row(1) - mesh.Vertices.row(0)).norm();
  for (const int rings : { 1, 2, 3 })
  {
    for (const double angle : { 2.0, 3.1 })
    {
      Points2 positions = size * twisted(mesh, (rings + 0.5) * ring, angle);
      positions.rowwise() += Eigen::RowVector2d(0.6, -0.3);
      const Points2 before = positions;
      const int flipped = countFlippedFaces(positions, mesh.Faces);
      ASSERT_GT(flipped, 0) << rings << ' ' << angle;
      const UntanglingReport report = untangleMap(mesh, requireDisk(mesh), positions);
      EXPECT_EQ(countFlippedFaces(positions, mesh.Faces), 0) << rings << ' ' << angle;
      EXPECT_EQ(report.RepairedFaces, flipped);
      EXPECT_EQ(report.FlippedFaces, 0);
      const std::vector<int> moved = movedVertices(before, positions);
      EXPECT_EQ(report.MovedVertices, static_cast<int>(moved.size()));
      for (const int v : moved)
      {
        EXPECT_LT(mesh.Vertices.row(v).norm(), (rings + 5.5) * ring) << rings << ' ' << angle;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MapUntangling, Twist, testing::Values(1.0, 1e-9));

// Every inner vertex is moved by up to an edge length in each coordinate: clusters of flipped faces that
// touch, everywhere.
Points2 noisy(const TriangleMesh& mesh, const std::vector<int>& loop)
{
  const double edge = (mesh.Vertices.row(1) - mesh.Vertices.row(0)).norm();
  std::vector<char> onBoundary(mesh.vertexCount(), 0);
  for (const int v : loop)
  {
    onBoundary[v] = 1;
  }
  samples::RandomNumbers random(9);
  Points2 positions = planar(mesh);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Eigen::RowVector2d noise = edge * random.point(-1.0, 1.0).head<2>();
    if (!onBoundary[v])
    {
      positions.row(v) += noise;
    }
  }
  return positions;
}

TEST(MapUntangling, UntanglesNoise)
{
  const TriangleMesh mesh = ringMesh(flatDisk(), 5000).Mesh;
  const std::vector<int> loop = requireDisk(mesh);
  Points2 positions = noisy(mesh, loop);
  ASSERT_GT(countFlippedFaces(positions, mesh.Faces), mesh.faceCount() / 10);
  const UntanglingReport report = untangleMap(mesh, loop, positions);
  EXPECT_EQ(report.FlippedFaces, 0);
  EXPECT_EQ(countFlippedFaces(positions, mesh.Faces), 0);
  EXPECT_LT(report.MovedVertices, mesh.vertexCount() / 2) << "most have no flipped face that needs them";
}

// Needles, as in the necks of protrusions. Stretching a map flips no face, so it should not change which
// faces can be untangled.
TEST(MapUntangling, UntanglesNoiseAmongNeedles)
{
  const TriangleMesh mesh = ringMesh(flatDisk(), 5000).Mesh;
  const std::vector<int> loop = requireDisk(mesh);
  Eigen::Matrix2d stretch; // by 30 and 1 / 30, along no axis
  stretch << 10.0, 14.0, 14.0, 19.7;
  stretch /= std::sqrt(stretch.determinant());
  Points2 positions = noisy(mesh, loop) * stretch;
  ASSERT_GT(countFlippedFaces(positions, mesh.Faces), mesh.faceCount() / 10);
  const TargetTriangles targets =
    trianglesOfArea(mesh, Eigen::VectorXd::Constant(mesh.faceCount(), 3.14 / mesh.faceCount()));
  std::vector<char> fixed(mesh.vertexCount(), 0);
  for (const int v : loop)
  {
    fixed[v] = 1;
  }
  const UntanglingReport report = untangleMap(mesh.Faces, fixed, targets, positions);
  EXPECT_EQ(report.FlippedFaces, 0);
  EXPECT_EQ(countFlippedFaces(positions, mesh.Faces), 0);
}

// Two fixed vertices have changed places: the faces around them stay flipped, are counted, and no vertex
// moves in vain.
TEST(MapUntangling, ReportsFacesThatStayFlipped)
{
  const TriangleMesh mesh = ringDisk();
  const std::vector<int> loop = requireDisk(mesh);
  Points2 positions = planar(mesh);
  positions.row(loop[0]).swap(positions.row(loop[10]));
  const Points2 before = positions;
  const int flipped = countFlippedFaces(positions, mesh.Faces);
  ASSERT_GT(flipped, 0);
  const UntanglingReport report = untangleMap(mesh, loop, positions);
  EXPECT_GT(report.FlippedFaces, 0);
  EXPECT_EQ(report.FlippedFaces, countFlippedFaces(positions, mesh.Faces));
  EXPECT_EQ(report.RepairedFaces, flipped - report.FlippedFaces);
  for (const int v : loop)
  {
    EXPECT_EQ(positions.row(v), before.row(v)) << v;
  }
  EXPECT_EQ(report.MovedVertices, static_cast<int>(movedVertices(before, positions).size()));
}

// Faces that cannot be untangled do not keep others, far away, from it.
TEST(MapUntangling, UntanglesTheRestOfAHopelessMap)
{
  const TriangleMesh mesh = ringDisk();
  const std::vector<int> loop = requireDisk(mesh);
  Points2 positions = planar(mesh);
  positions.row(loop[0]).swap(positions.row(loop[10]));
  positions.row(0) += 1.1 * (positions.row(1) - positions.row(0));
  const int flipped = countFlippedFaces(positions, mesh.Faces);
  const UntanglingReport report = untangleMap(mesh, loop, positions);
  EXPECT_GT(report.FlippedFaces, 0);
  EXPECT_GE(report.RepairedFaces, 2);
  EXPECT_EQ(report.RepairedFaces, flipped - report.FlippedFaces);
}

// A twist in the middle can be undone, two exchanged boundary vertices cannot. The latter come first in
// the list of faces: all or none means that the twist is left as it was.
TEST(MapUntangling, EndsAtTheFirstFaceThatStaysFlippedIfThatIsAskedFor)
{
  TriangleMesh mesh = ringDisk();
  mesh.Faces = mesh.Faces.colwise().reverse().eval();
  const std::vector<int> loop = requireDisk(mesh);
  std::vector<char> fixed(mesh.vertexCount(), 0);
  for (const int v : loop)
  {
    fixed[v] = 1;
  }
  const double ring = (mesh.Vertices.row(1) - mesh.Vertices.row(0)).norm();
  Points2 start = twisted(mesh, 1.5 * ring, 3.1);
  const int twist = countFlippedFaces(start, mesh.Faces);
  start.row(loop[0]).swap(start.row(loop[10]));
  const auto repaired = [&](bool allOrNone)
  {
    Points2 positions = start;
    UntanglingOptions options;
    options.AllOrNone = allOrNone;
    options.WorkPerVertex = 1000.0;
    const TargetTriangles targets = similarTriangles(mesh, positions);
    const UntanglingReport report = untangleMap(mesh.Faces, fixed, targets, positions, options);
    EXPECT_GT(report.FlippedFaces, 0);
    EXPECT_EQ(report.FlippedFaces, countFlippedFaces(positions, mesh.Faces));
    return report.RepairedFaces;
  };
  EXPECT_GE(repaired(false), twist);
  EXPECT_LT(repaired(true), twist);
}

// The whole map must move into the lens between a short arc and its chord, as a piece of the surface
// must that an edge between two boundary vertices cuts off.
TEST(MapUntangling, FitsIntoTheLensOfAChord)
{
  const TriangleMesh mesh = ringDisk();
  const std::vector<int> loop = requireDisk(mesh);
  Points2 positions = planar(mesh);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const double angle = 0.02 * static_cast<double>(i) / loop.size();
    positions.row(loop[i]) << std::cos(angle), std::sin(angle);
  }
  const int flipped = countFlippedFaces(positions, mesh.Faces);
  ASSERT_GT(flipped, 0);
  const UntanglingReport report = untangleMap(mesh, loop, positions);
  EXPECT_EQ(report.FlippedFaces, 0);
  EXPECT_EQ(countFlippedFaces(positions, mesh.Faces), 0);
}

// Nothing is changed where nothing is flipped.
TEST(MapUntangling, LeavesAGoodMapAlone)
{
  const TriangleMesh mesh = sunflowerMesh(gaussianBump(1.0, 0.3), 2000).Mesh;
  const Points2 before = planar(mesh);
  Points2 positions = before;
  const UntanglingReport report = untangleMap(mesh, requireDisk(mesh), positions);
  EXPECT_EQ(positions, before);
  EXPECT_EQ(report.RepairedFaces + report.FlippedFaces + report.MovedVertices, 0);
  EXPECT_EQ(report.GreatestMove, 0.0);
}

TEST(MapUntangling, CanBeCancelled)
{
  const TriangleMesh mesh = ringDisk();
  const double ring = (mesh.Vertices.row(1) - mesh.Vertices.row(0)).norm();
  Points2 positions = twisted(mesh, 3.5 * ring, 3.1);
  EXPECT_THROW(
    untangleMap(mesh, requireDisk(mesh), positions, [](double, const char*) { return false; }),
    Cancelled);
}

// Single vertices, too, are not moved without a report.
TEST(MapUntangling, CanBeCancelledBeforeTheFirstPatch)
{
  const TriangleMesh mesh = ringDisk();
  Points2 positions = planar(mesh);
  positions.row(0) += 1.1 * (positions.row(1) - positions.row(0));
  EXPECT_THROW(
    untangleMap(mesh, requireDisk(mesh), positions, [](double, const char*) { return false; }),
    Cancelled);
}

// Two exchanged boundary vertices take patch after patch, and Newton's method goes on for long in each.
// The progress of all this is one fraction, and an abort is served at each of its reports.
TEST(MapUntangling, ReportsWithinTheWorkOnOneFace)
{
  const TriangleMesh mesh = ringDisk();
  const std::vector<int> loop = requireDisk(mesh);
  Points2 start = planar(mesh);
  start.row(loop[0]).swap(start.row(loop[10]));
  std::map<double, int> reports;
  double last = 0.0;
  Points2 positions = start;
  untangleMap(mesh,
    loop,
    positions,
    [&](double fraction, const char*)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      ++reports[fraction];
      return true;
    });
  const auto most = std::max_element(
    reports.begin(), reports.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  EXPECT_GT(most->second, 50);
  positions = start;
  int left = 50;
  EXPECT_THROW(untangleMap(mesh,
                 loop,
                 positions,
                 [&](double fraction, const char*) { return fraction < most->first || left-- > 0; }),
    Cancelled);
}

// The whole disk as a patch, whose targets are the faces of the undistorted disk.
FlatPatch patchOf(const TriangleMesh& mesh, const Points2& positions)
{
  FlatPatch patch;
  patch.Positions = positions;
  patch.FreeVertices = mesh.vertexCount() - static_cast<int>(requireDisk(mesh).size());
  patch.Faces = mesh.Faces;
  const Points2 perfect = planar(mesh);
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const Eigen::RowVector2d first = perfect.row(mesh.Faces(f, 0));
    patch.Targets.push_back({ (perfect.row(mesh.Faces(f, 1)) - first).transpose(),
      (perfect.row(mesh.Faces(f, 2)) - first).transpose() });
  }
  return patch;
}

// Faces get the shapes and areas of their targets where all of them can have these.
TEST(PatchUntangling, FindsTheTargets)
{
  const TriangleMesh mesh = ringMesh(flatDisk(), 400).Mesh;
  const double ring = (mesh.Vertices.row(1) - mesh.Vertices.row(0)).norm();
  for (const double areaWeight : { 0.0, 0.1, 10.0 })
  {
    FlatPatch patch = patchOf(mesh, twisted(mesh, 3.5 * ring, 2.0));
    const UntangledPatch result = untanglePatch(patch, areaWeight);
    EXPECT_TRUE(result.Positive) << areaWeight;
    EXPECT_GT(result.Steps, 3);
    EXPECT_LT((patch.Positions - planar(mesh)).rowwise().norm().maxCoeff(), 0.05 * ring) << areaWeight;
  }
}

TEST(PatchUntangling, ReportsEveryStep)
{
  const TriangleMesh mesh = ringMesh(flatDisk(), 400).Mesh;
  const double ring = (mesh.Vertices.row(1) - mesh.Vertices.row(0)).norm();
  FlatPatch silent = patchOf(mesh, twisted(mesh, 3.5 * ring, 2.0));
  FlatPatch patch = silent;
  FlatPatch aborted = silent;
  const UntangledPatch result = untanglePatch(silent, 0.1);
  std::vector<double> fractions;
  const auto note = [&](double fraction, const char*)
  {
    fractions.push_back(fraction);
    return true;
  };
  EXPECT_EQ(untanglePatch(patch, 0.1, note).Steps, result.Steps);
  EXPECT_EQ(patch.Positions, silent.Positions) << "reports change nothing";
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  fractions.erase(std::unique(fractions.begin(), fractions.end()), fractions.end());
  EXPECT_EQ(fractions.size(), static_cast<std::size_t>(result.Steps));
  int left = 2;
  EXPECT_THROW(
    untanglePatch(aborted, 0.1, [&left](double, const char*) { return left-- > 0; }), Cancelled);
}

// A patch of so many vertices is factored in another thread, with reports meanwhile.
TEST(PatchUntangling, AnAbortDoesNotWaitForTheFactorOfALargePatch)
{
  const TriangleMesh mesh = ringMesh(flatDisk(), 8000).Mesh;
  const double ring = (mesh.Vertices.row(1) - mesh.Vertices.row(0)).norm();
  FlatPatch patch = patchOf(mesh, twisted(mesh, 3.5 * ring, 2.0));
  FlatPatch silent = patch;
  const UntangledPatch result = untanglePatch(silent, 0.1);
  samples::AbandonedCall before; // while it runs, the factor waits and reports
  int reports = 0;
  const UntangledPatch again = untanglePatch(patch,
    0.1,
    [&](double fraction, const char*)
    {
      EXPECT_TRUE(before.isOver() || fraction == 0.0);
      if (++reports == 3)
      {
        before.end();
      }
      return true;
    });
  EXPECT_GE(reports, 3 + result.Steps - 1);
  EXPECT_EQ(again.Steps, result.Steps);
  EXPECT_EQ(patch.Positions, silent.Positions);
}

// Targets need not be similar to the faces of the map: those within half the radius ask for twice the
// area.
TEST(PatchUntangling, AreasFollowTheirTargets)
{
  const TriangleMesh mesh = ringMesh(flatDisk(), 400).Mesh;
  const Points2 start = planar(mesh);
  const auto isWithin = [&](int f) { return start.row(mesh.Faces(f, 0)).norm() < 0.5; };
  const auto areaWithin = [&](const Points2& positions)
  {
    const Eigen::VectorXd areas = signedFaceAreas(positions, mesh.Faces);
    double sum = 0.0;
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      sum += isWithin(f) ? areas[f] : 0.0;
    }
    return sum;
  };
  const double within = areaWithin(start);
  const double all = signedFaceAreas(start, mesh.Faces).sum();
  double last = within;
  for (const double areaWeight : { 1.0, 10.0, 100.0 })
  {
    FlatPatch patch = patchOf(mesh, start);
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      const double stretch = std::sqrt(isWithin(f) ? 2.0 : (all - 2.0 * within) / (all - within));
      patch.Targets[f].Second *= stretch;
      patch.Targets[f].Third *= stretch;
    }
    EXPECT_TRUE(untanglePatch(patch, areaWeight).Positive);
    EXPECT_GT(areaWithin(patch.Positions), last) << areaWeight;
    last = areaWithin(patch.Positions);
  }
  EXPECT_NEAR(last, 2.0 * within, 0.02 * last);
}

TEST(PatchUntangling, SpringsInAConvexRimFlipNothing)
{
  const TriangleMesh mesh = ringMesh(flatDisk(), 400).Mesh;
  FlatPatch patch = patchOf(mesh, Points2::Zero(mesh.vertexCount(), 2));
  patch.Positions.bottomRows(mesh.vertexCount() - patch.FreeVertices) =
    planar(mesh).bottomRows(mesh.vertexCount() - patch.FreeVertices);
  relaxPatch(patch);
  EXPECT_EQ(countFlippedFaces(patch.Positions, patch.Faces), 0);
}

// A face with three different sides, whichever corner is its first: the target has them all in one
// ratio, in the same order, and the area that was asked for.
TEST(TargetTriangles, AreSimilarToTheFacesAndHaveTheAreas)
{
  TriangleMesh mesh{ Points3(3, 3), FaceMatrix(3, 3) };
  mesh.Vertices << 0.0, 0.0, 5.0, 4.0, 0.0, 5.0, 1.0, 0.0, 7.0;
  mesh.Faces << 0, 1, 2, 1, 2, 0, 2, 0, 1;
  const TargetTriangles targets = trianglesOfArea(mesh, Eigen::Vector3d(1.0, 9.0, 16.0));
  for (int f = 0; f < 3; ++f)
  {
    const TargetTriangle target = targets(f);
    const Eigen::Vector2d corners[3] = { { 0.0, 0.0 }, target.Second, target.Third };
    const double scale = f == 0 ? 0.5 : f == 1 ? 1.5 : 2.0; // the face's area is 4
    for (int k = 0; k < 3; ++k)
    {
      const double side =
        (mesh.Vertices.row(mesh.Faces(f, (k + 1) % 3)) - mesh.Vertices.row(mesh.Faces(f, k))).norm();
      EXPECT_NEAR((corners[(k + 1) % 3] - corners[k]).norm(), scale * side, 1e-14 * side)
        << f << ", " << k;
    }
    EXPECT_NEAR(0.5 * (target.Second.x() * target.Third.y() - target.Second.y() * target.Third.x()),
      4.0 * scale * scale,
      1e-13);
  }
}

} // namespace
