// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "FlatMap/FlatMapTransfer.h"
#include "Mesh/DisjointSets.h"
#include "Mesh/FaceOrientation.h"
#include "Remeshing/IsotropicRemeshing.h"
#include "Support/SampleSurfaces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::samples;

// The developable wall of a cylinder: its angle and height are its exact flat map.
FlattenedSurface unrolled(TriangleMesh wall)
{
  FlattenedSurface flattened;
  flattened.Positions.resize(wall.vertexCount(), 2);
  for (int v = 0; v < wall.vertexCount(); ++v)
  {
    flattened.Positions.row(v) << std::atan2(wall.Vertices(v, 1), wall.Vertices(v, 0)),
      wall.Vertices(v, 2);
  }
  flattened.Surface = std::move(wall);
  return flattened;
}

// Half of a cylinder of radius 1, about the x axis' side, so that the angle has no jump.
TriangleMesh halfCylinder(int around, int along, double height)
{
  const TriangleMesh whole = cylinder(around, along, height);
  std::set<int> back;
  for (int f = 0; f < whole.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (whole.Vertices(whole.Faces(f, k), 0) < -1e-9)
      {
        back.insert(f);
      }
    }
  }
  std::vector<int> kept;
  for (int f = 0; f < whole.faceCount(); ++f)
  {
    if (!back.count(f))
    {
      kept.push_back(f);
    }
  }
  return extractFaces(whole, kept).Mesh;
}

TEST(FlatMapTransfer, EveryPointOfTheSameSurfaceKeepsItsPosition)
{
  const FlattenedSurface flattened = unrolled(halfCylinder(64, 20, 3.0));
  const TransferredMap map = transferFlatMap(flattened, flattened.Surface);
  EXPECT_EQ(std::count(map.Survived.begin(), map.Survived.end(), 1), flattened.Surface.vertexCount());
  EXPECT_LT((map.Positions - flattened.Positions).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(map.LargestDistance, 1e-14);

  TriangleMesh reversed = flattened.Surface; // and moved, so that no face is shared
  reversed.Vertices *= 1.0 + 1e-9;
  reversed.Faces.col(1).swap(reversed.Faces.col(2));
  const TransferredMap other = transferFlatMap(flattened, reversed);
  EXPECT_GT(std::count(other.Survived.begin(), other.Survived.end(), 1),
    0.9 * flattened.Surface.vertexCount()); // some of the boundary lie beyond it now
}

TEST(FlatMapTransfer, FollowsARemeshedSurface)
{
  const TriangleMesh original = halfCylinder(128, 61, 3.0);
  const FlattenedSurface flattened = unrolled(remeshIsotropically(original, 0.08).Mesh);
  const TransferredMap map = transferFlatMap(flattened, original);
  double greatest = 0.0;
  int lost = 0;
  for (int v = 0; v < original.vertexCount(); ++v)
  {
    const bool edge = std::abs(original.Vertices(v, 0)) < 1e-9 || original.Vertices(v, 2) == 0.0 ||
                      original.Vertices(v, 2) == 3.0;
    EXPECT_TRUE(map.Survived[v] || edge) << v;
    lost += !map.Survived[v];
    if (map.Survived[v])
    {
      const double angle = std::atan2(original.Vertices(v, 1), original.Vertices(v, 0));
      greatest = std::max(
        greatest, (map.Positions.row(v) - Eigen::RowVector2d(angle, original.Vertices(v, 2))).norm());
    }
  }
  EXPECT_LT(greatest, 0.08 * 0.08); // of second order in the edge length
  EXPECT_LT(map.LargestDistance, 0.08 * 0.08 / 4.0);
  EXPECT_LT(lost, 64);
}

TEST(FlatMapTransfer, LosesWhatLiesOverAHole)
{
  const TriangleMesh original = halfCylinder(64, 40, 3.0);
  std::vector<int> kept;
  for (int f = 0; f < original.faceCount(); ++f)
  {
    double height = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      height = std::max(height, original.Vertices(original.Faces(f, k), 2));
    }
    if (height < 2.0 + 1e-9)
    {
      kept.push_back(f);
    }
  }
  const FlattenedSurface flattened = unrolled(extractFaces(original, kept).Mesh);
  const TransferredMap map = transferFlatMap(flattened, original, 10.0); // tolerance alone keeps all
  for (int v = 0; v < original.vertexCount(); ++v)
  {
    EXPECT_EQ(map.Survived[v] != 0, original.Vertices(v, 2) < 2.0 + 1e-9) << original.Vertices(v, 2);
  }
}

TEST(FlatMapTransfer, DoesNotJumpToTheOtherSideOfAFold)
{
  // Two parallel sheets that face each other, 0.01 apart; only the lower one was flattened.
  const TriangleMesh lower =
    meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  const TriangleMesh upper =
    meshOf({ { 0.2, 0.2, 0.01 }, { 0.5, 0.2, 0.01 }, { 0.5, 0.6, 0.01 } }, { { 0, 2, 1 } });
  FlattenedSurface flattened{ lower, lower.Vertices.leftCols(2) };
  const TransferredMap map = transferFlatMap(flattened, both(lower, upper));
  EXPECT_EQ(map.Survived, (std::vector<char>{ 1, 1, 1, 1, 0, 0, 0 }));

  // Turned over as a whole is no reason to lose anything.
  TriangleMesh turned = lower;
  turned.Faces.col(1).swap(turned.Faces.col(2));
  EXPECT_EQ(transferFlatMap(flattened, turned).Survived, (std::vector<char>{ 1, 1, 1, 1 }));
}

TEST(FlatMapTransfer, IsTheSameAtEveryScale)
{
  const TriangleMesh original = halfCylinder(64, 30, 3.0);
  const FlattenedSurface flattened = unrolled(remeshIsotropically(original, 0.1).Mesh);
  const TransferredMap map = transferFlatMap(flattened, original);
  for (const double scale : { 1e-9, 1e9 })
  {
    FlattenedSurface scaled = flattened;
    scaled.Surface.Vertices *= scale;
    TriangleMesh target = original;
    target.Vertices *= scale;
    const TransferredMap other = transferFlatMap(scaled, target);
    EXPECT_EQ(other.Survived, map.Survived);
    EXPECT_LT((other.Positions - map.Positions).cwiseAbs().maxCoeff(), 1e-9);
  }
}

// The mesh with the edges of @p seam opened: each vertex of a seam once for each bank.
TriangleMesh openedAlong(const TriangleMesh& mesh, const std::set<std::pair<int, int>>& seam)
{
  DisjointSets corners(3 * mesh.faceCount());
  std::map<std::pair<int, int>, std::pair<int, int>> sides; // each edge to the corners at its ends
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      std::pair<int, int> ends(3 * f + k, 3 * f + (k + 1) % 3);
      if (mesh.Faces(f, k) > mesh.Faces(f, (k + 1) % 3))
      {
        std::swap(ends.first, ends.second);
      }
      const std::pair<int, int> edge(mesh.Faces(f, ends.first % 3), mesh.Faces(f, ends.second % 3));
      const auto [other, isNew] = sides.emplace(edge, ends);
      if (!isNew && seam.count(edge) == 0)
      {
        corners.join(ends.first, other->second.first);
        corners.join(ends.second, other->second.second);
      }
    }
  }
  TriangleMesh opened = mesh;
  std::map<int, int> index; // of the sets of corners
  for (int c = 0; c < 3 * mesh.faceCount(); ++c)
  {
    opened.Faces(c / 3, c % 3) =
      index.emplace(corners.find(c), static_cast<int>(index.size())).first->second;
  }
  opened.Vertices.resize(static_cast<Eigen::Index>(index.size()), 3);
  for (int c = 0; c < 3 * mesh.faceCount(); ++c)
  {
    opened.Vertices.row(opened.Faces(c / 3, c % 3)) = mesh.Vertices.row(mesh.Faces(c / 3, c % 3));
  }
  return opened;
}

// A flat surface with gaping seams: every vertex on the boundary is drawn towards its own faces.
FlattenedSurface gaping(TriangleMesh flat)
{
  FlattenedSurface flattened;
  Points2 sums = Points2::Zero(flat.vertexCount(), 2);
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(flat.vertexCount());
  for (int f = 0; f < flat.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      sums.row(flat.Faces(f, k)) += faceCorners(flat, f).colwise().mean().head<2>();
      counts[flat.Faces(f, k)] += 1.0;
    }
  }
  const Points2 places = flat.Vertices.leftCols(2);
  flattened.Positions =
    places + 0.2 * (sums.array().colwise() / counts.array() - places.array()).matrix();
  flattened.Surface = std::move(flat);
  return flattened;
}

// Checks that every face of @p original lies where the same face of the flattened surface lies, up to
// @p tolerance.
void expectEveryFaceInItsPlace(const FlattenedSurface& flattened,
  const TriangleMesh& original,
  const TransferredMap& map,
  double tolerance = 1e-12)
{
  ASSERT_EQ(map.Part.Mesh.faceCount(), original.faceCount());
  EXPECT_EQ(map.Part.Mesh.vertexCount(), flattened.Surface.vertexCount());
  EXPECT_EQ(map.KeptVertices, original.vertexCount());
  EXPECT_EQ(map.FacesAcrossSeams, 0);
  double greatest = 0.0;
  for (int f = 0; f < original.faceCount(); ++f)
  {
    ASSERT_EQ(map.Part.Faces[f], f);
    for (int k = 0; k < 3; ++k)
    {
      const int v = map.Part.Mesh.Faces(f, k);
      EXPECT_EQ(VertexOrigins::InnerIterator(map.Part.Vertices, v).col(), original.Faces(f, k));
      greatest = std::max(greatest,
        (map.PartPositions.row(v) - flattened.Positions.row(flattened.Surface.Faces(f, k))).norm());
    }
  }
  EXPECT_LE(greatest, tolerance);
}

TEST(FlatMapTransfer, PutsEachFaceOnItsBankOfASeam)
{
  // Three slits from the middle of a grid of 11 x 11 vertices: three banks there, one place at each end.
  const TriangleMesh original = rectangleGrid(11, 11, 2.0);
  std::set<std::pair<int, int>> slits;
  for (int i = 0; i < 3; ++i)
  {
    slits.insert({ 60 + i, 61 + i });
    slits.insert({ 59 - i, 60 - i });
    slits.insert({ 60 + 11 * i, 71 + 11 * i });
  }
  const FlattenedSurface flattened = gaping(openedAlong(original, slits));
  ASSERT_EQ(flattened.Surface.vertexCount(), 121 + 2 + 6);
  TriangleMesh moved = original; // so that the two surfaces have no face in common
  moved.Vertices *= 1.0 + 1e-9;
  for (const TriangleMesh& target : { original, moved })
  {
    const TransferredMap map = transferFlatMap(flattened, target);
    expectEveryFaceInItsPlace(flattened, target, map, 1e-8);
    EXPECT_EQ(map.RepeatedVertices, 7);
    EXPECT_EQ(countFlippedFaces(map.PartPositions, map.Part.Mesh.Faces), 0);
  }
}

TEST(FlatMapTransfer, KeepsTheFacesThatTheSurfacesShareWhereTheyMeetThemselves)
{
  // A strip wound twice around the same prism, and half a row higher after each turn: its turns lie upon
  // each other, and where one has a vertex the other has none.
  TriangleMesh strip = rectangleGrid(49, 5, 12.0);
  const Points2 flat = strip.Vertices.leftCols(2);
  const double row = flat(49, 1) - flat(0, 1);
  for (int v = 0; v < strip.vertexCount(); ++v)
  {
    const int column = v % 49;
    const double angle = 2.0 * EIGEN_PI * (column % 24) / 24;
    strip.Vertices.row(v) << std::cos(angle), std::sin(angle), flat(v, 1) + row * column / 48;
  }
  const FlattenedSurface flattened{ strip, flat };
  const TransferredMap map = transferFlatMap(flattened, strip);
  expectEveryFaceInItsPlace(flattened, strip, map, 0.0);

  TriangleMesh reversed = strip;
  reversed.Faces.col(1).swap(reversed.Faces.col(2));
  expectEveryFaceInItsPlace({ reversed, flat }, reversed, transferFlatMap(flattened, reversed), 0.0);

  TriangleMesh mixed = strip; // one face against its neighbours
  std::swap(mixed.Faces(100, 1), mixed.Faces(100, 2));
  expectEveryFaceInItsPlace({ mixed, flat }, mixed, transferFlatMap(flattened, mixed), 0.0);
}

TEST(FlatMapTransfer, ASharedFaceKeepsACornerWhoseNormalPointsTheOtherWay)
{
  TriangleMesh sheet = rectangleGrid(8, 6, 2.0);
  std::vector<int> count(sheet.vertexCount(), 0);
  for (Eigen::Index i = 0; i < sheet.Faces.size(); ++i)
  {
    ++count[sheet.Faces.data()[i]];
  }
  const Points2 flat = sheet.Vertices.leftCols(2);
  TriangleMesh target = sheet;
  int reversed = 0; // faces at a corner of the sheet that no other face has
  for (int f = 0; f < sheet.faceCount(); ++f)
  {
    if (count[sheet.Faces(f, 0)] == 1 || count[sheet.Faces(f, 1)] == 1 || count[sheet.Faces(f, 2)] == 1)
    {
      std::swap(target.Faces(f, 1), target.Faces(f, 2));
      ++reversed;
    }
  }
  ASSERT_EQ(reversed, 2);
  const TransferredMap map = transferFlatMap({ sheet, flat }, target);
  expectEveryFaceInItsPlace({ target, flat }, target, map, 0.0);
}

TEST(FlatMapTransfer, LosesTheOtherSideOfTwoSheetsThatLieUponEachOther)
{
  const TriangleMesh sheet = rectangleGrid(8, 6, 2.0);
  TriangleMesh sheets = sheet;
  sheets.Vertices.conservativeResize(2 * sheet.vertexCount(), 3);
  sheets.Vertices.bottomRows(sheet.vertexCount()) = sheet.Vertices;
  sheets.Faces.conservativeResize(2 * sheet.faceCount(), 3);
  sheets.Faces.bottomRows(sheet.faceCount()) =
    sheet.Faces.rowwise().reverse().array() + sheet.vertexCount();
  const TransferredMap map = transferFlatMap({ sheet, sheet.Vertices.leftCols(2) }, sheets);
  EXPECT_EQ(map.Part.Mesh.faceCount(), sheet.faceCount());
  EXPECT_EQ(map.Part.Faces.back(), sheet.faceCount() - 1);
}

TEST(FlatMapTransfer, LeavesOutTheFacesThroughWhichASeamRuns)
{
  std::set<std::pair<int, int>> slit; // on the middle row of 21, with both ends inside
  for (int i = 215; i < 225; ++i)
  {
    slit.insert({ i, i + 1 });
  }
  const TriangleMesh fine = rectangleGrid(21, 21, 2.0);
  const FlattenedSurface flattened = gaping(openedAlong(fine, slit));
  const Eigen::RowVector3d begin = fine.Vertices.row(215);
  const Eigen::RowVector3d end = fine.Vertices.row(225);
  for (const int n : { 4, 8, 14, 26, 52 }) // other triangulations, none with a row of points on the slit
  {
    SCOPED_TRACE(n);
    const TriangleMesh original = rectangleGrid(n, n, 2.0);
    std::vector<int> expected;
    for (int f = 0; f < original.faceCount(); ++f)
    {
      bool isCrossed = false;
      const Eigen::Matrix3d corners = faceCorners(original, f);
      const auto side = [&corners](int k, const Eigen::RowVector3d& x)
      {
        const Eigen::RowVector3d edge = corners.row((k + 1) % 3) - corners.row(k);
        const Eigen::RowVector3d offset = x - corners.row(k);
        return edge.x() * offset.y() - edge.y() * offset.x();
      };
      for (int i = 0; i <= 5000; ++i)
      {
        const Eigen::RowVector3d x = begin + i / 5000.0 * (end - begin);
        isCrossed |= side(0, x) > 1e-9 && side(1, x) > 1e-9 && side(2, x) > 1e-9;
      }
      if (!isCrossed)
      {
        expected.push_back(f);
      }
    }
    const TransferredMap map = transferFlatMap(flattened, original);
    EXPECT_EQ(map.Part.Faces, expected);
    EXPECT_EQ(map.FacesAcrossSeams, original.faceCount() - static_cast<int>(expected.size()));
    EXPECT_EQ(countFlippedFaces(map.PartPositions, map.Part.Mesh.Faces), 0);
  }
}

TEST(FlatMapTransfer, UnrollsACylinderThatWasCutOpen)
{
  const int around = 48;
  const int along = 10;
  const TriangleMesh original = cylinder(around, along, 2.0);
  std::set<std::pair<int, int>> seam; // the edges that lie in the half-plane y = 0, x > 0
  for (int f = 0; f < original.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::pair<int, int> edge =
        std::minmax({ original.Faces(f, k), original.Faces(f, (k + 1) % 3) });
      const auto isOnLine = [&original](int v)
      { return std::abs(original.Vertices(v, 1)) < 1e-12 && original.Vertices(v, 0) > 0.0; };
      if (isOnLine(edge.first) && isOnLine(edge.second))
      {
        seam.insert(edge);
      }
    }
  }
  FlattenedSurface flattened;
  flattened.Surface = openedAlong(original, seam);
  const int rows = flattened.Surface.vertexCount() - original.vertexCount();
  EXPECT_EQ(rows, static_cast<int>(seam.size()) + 1);
  flattened.Positions.resize(flattened.Surface.vertexCount(), 2);
  for (int f = 0; f < flattened.Surface.faceCount(); ++f)
  {
    const Eigen::RowVector3d middle = faceCorners(flattened.Surface, f).colwise().mean();
    const double turn = std::atan2(middle.y(), middle.x());
    for (int k = 0; k < 3; ++k) // the angle of each corner is counted from that of the face
    {
      const int v = flattened.Surface.Faces(f, k);
      const Eigen::RowVector3d x = flattened.Surface.Vertices.row(v);
      const double step = std::remainder(std::atan2(x.y(), x.x()) - turn, 2.0 * Pi);
      flattened.Positions.row(v) << (turn < 0.0 ? turn + 2.0 * Pi : turn) + step, x.z();
    }
  }
  const TransferredMap map = transferFlatMap(flattened, original);
  expectEveryFaceInItsPlace(flattened, original, map);
  EXPECT_EQ(map.RepeatedVertices, rows);
  EXPECT_NEAR(signedFaceAreas(map.PartPositions, map.Part.Mesh.Faces).sum(), 2.0 * Pi * 2.0, 1e-9);

  // Turned by less than half an edge, the seam runs through one column of faces: those alone are lost.
  TriangleMesh turned = original;
  turned.Vertices.col(2) = (0.1 + 0.9 * original.Vertices.col(2).array()).matrix(); // inside the border
  const double angle = 0.4 * 2.0 * Pi / around;
  turned.Vertices.col(0) =
    std::cos(angle) * original.Vertices.col(0) - std::sin(angle) * original.Vertices.col(1);
  turned.Vertices.col(1) =
    std::sin(angle) * original.Vertices.col(0) + std::cos(angle) * original.Vertices.col(1);
  const TransferredMap beside = transferFlatMap(flattened, turned);
  EXPECT_EQ(beside.KeptVertices, turned.vertexCount());
  EXPECT_EQ(beside.RepeatedVertices, 0);
  EXPECT_EQ(beside.FacesAcrossSeams, 2 * (rows - 1));
  EXPECT_EQ(beside.Part.Mesh.faceCount(), turned.faceCount() - 2 * (rows - 1));
  const Eigen::VectorXd areas = signedFaceAreas(beside.PartPositions, beside.Part.Mesh.Faces);
  const double area = 2.0 * Pi * 1.8 / turned.faceCount();
  EXPECT_NEAR(areas.minCoeff(), area, 0.01 * area);
  EXPECT_NEAR(areas.maxCoeff(), area, 0.01 * area);
}

TEST(FlatMapTransfer, WithoutASeamEveryVertexHasOnePlace)
{
  const TriangleMesh original = halfCylinder(64, 30, 3.0);
  const FlattenedSurface flattened = unrolled(remeshIsotropically(original, 0.1).Mesh);
  const TransferredMap map = transferFlatMap(flattened, original);
  std::vector<int> faces;
  for (int f = 0; f < original.faceCount(); ++f)
  {
    if (map.Survived[original.Faces(f, 0)] && map.Survived[original.Faces(f, 1)] &&
        map.Survived[original.Faces(f, 2)])
    {
      faces.push_back(f);
    }
  }
  const DerivedMesh part = extractFaces(original, faces);
  EXPECT_EQ(map.Part.Faces, part.Faces);
  EXPECT_EQ(map.Part.Mesh.Faces, part.Mesh.Faces);
  EXPECT_EQ(map.Part.Mesh.Vertices, part.Mesh.Vertices);
  EXPECT_EQ(map.PartPositions, Points2(part.Vertices * map.Positions));
  EXPECT_EQ(map.RepeatedVertices, 0);
  EXPECT_EQ(map.KeptVertices, part.Mesh.vertexCount());
}

TEST(FlatMapTransfer, NamesWhatIsWrong)
{
  const FlattenedSurface flattened = unrolled(halfCylinder(64, 20, 3.0));
  const TriangleMesh far = moved(flattened.Surface, 100.0, 0.0, 0.0);
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { transferFlatMap(flattened, far); }), "raise the tolerance"));
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { transferFlatMap(flattened, flattened.Surface, -1.0); }),
      "tolerance is -1"));
  EXPECT_THROW(transferFlatMap(flattened, {}), InvalidInput);
  EXPECT_THROW(
    transferFlatMap(
      flattened, flattened.Surface, 0.0, [](double fraction, const char*) { return fraction < 0.5; }),
    Cancelled);
}

} // namespace
