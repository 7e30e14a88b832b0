// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/AreaPreservingDisk.h"
#include "Base/Errors.h"
#include "Conformal/ConformalDisk.h"
#include "FlatMap/FlatMapLocation.h"
#include "Support/RandomNumbers.h"
#include "Support/SampleSurfaces.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>

namespace
{

using namespace flattening;
using namespace flattening::samples;

struct RoundTrip
{
  double GreatestError = 0.0; // in space, share of the diagonal
  int Lost = 0;               // outside of the surface or of the map
  int Points = 0;
};

// A random place in a random face, its point on the map looked up there, and the point in space that
// belongs to what was found.
RoundTrip roundTrip(const TriangleMesh& surface, const Points2& positions, int points)
{
  const FlatMapLocation location(surface, positions);
  const double diagonal =
    (surface.Vertices.colwise().maxCoeff() - surface.Vertices.colwise().minCoeff()).norm();
  RandomNumbers random(7);
  RoundTrip result;
  for (result.Points = 0; result.Points < points; ++result.Points)
  {
    MapPlace place{ random.integer(0, surface.faceCount() - 1), {}, 0.0, true };
    const double a = std::sqrt(random.real(0.0, 1.0));
    const double b = random.real(0.0, 1.0);
    place.Weights = { 1.0 - a, a * (1.0 - b), a * b };
    const Eigen::RowVector3d start = location.surfacePoint(place);
    const MapPlace onSurface = location.onSurface(start);
    const Eigen::RowVector2d flat = location.mapPoint(onSurface);
    const auto note = [&](const MapPlace& onMap)
    {
      result.Lost += !onSurface.Inside || !onMap.Inside;
      result.GreatestError =
        std::max(result.GreatestError, (location.surfacePoint(onMap) - start).norm() / diagonal);
    };
    note(location.onMap(flat, place.Face));
    if (result.Points % 10 == 0) // the slower way
    {
      note(location.onMap(flat));
    }
  }
  return result;
}

void expectRoundTrip(const analytic::SurfaceOfRevolution& surface, int vertices, int points)
{
  const TriangleMesh mesh = analytic::sunflowerMesh(surface, vertices).Mesh;
  const Points2 flat = areaPreservingDiskMap(mesh, conformalDiskMap(mesh).Positions).Map.Positions;
  const RoundTrip trip = roundTrip(mesh, flat, points);
  std::cout << trip.Points << " random points there and back on " << mesh.faceCount()
            << " faces: greatest error " << trip.GreatestError << " of the diagonal, " << trip.Lost
            << " lost\n";
  EXPECT_EQ(trip.Lost, 0);
  EXPECT_LE(trip.GreatestError, 1e-6);
}

TEST(FlatMapLocation, AMillionPointsThereAndBack)
{
  expectRoundTrip(analytic::gaussianBump(3.0, 0.2), 10000, 1000000);
}

TEST(FlatMapLocation, ThereAndBackInAHorn)
{
  expectRoundTrip(analytic::capsule(6.0), 5000, 100000);
}

// Faces a billion times as long as high, side by side.
TEST(FlatMapLocation, ThereAndBackInNeedles)
{
  constexpr double Width = 1e-9;
  TriangleMesh strip = rectangleGrid(60, 2, 59.0 * Width);
  const TriangleMesh wide = rectangleGrid(60, 2, 59.0);
  const RoundTrip trip = roundTrip(wide, strip.Vertices.leftCols<2>(), 20000);
  EXPECT_EQ(trip.Lost, 0);
  EXPECT_LE(trip.GreatestError, 1e-6);
}

TEST(FlatMapLocation, CornersAndEdgesBelongToOneOfTheirFaces)
{
  const TriangleMesh square = rectangleGrid(4, 4, 2.0);
  const FlatMapLocation location(square, square.Vertices.leftCols<2>());
  for (int f = 0; f < square.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::RowVector2d a = square.Vertices.row(square.Faces(f, k)).leftCols<2>();
      const Eigen::RowVector2d b = square.Vertices.row(square.Faces(f, (k + 1) % 3)).leftCols<2>();
      for (const Eigen::RowVector2d& point : { a, Eigen::RowVector2d(0.3 * a + 0.7 * b) })
      {
        const MapPlace place = location.onMap(point);
        EXPECT_TRUE(place.Inside);
        EXPECT_LT((location.mapPoint(place) - point).norm(), 1e-15);
        EXPECT_EQ(place.Face, location.onMap(point).Face);
      }
    }
  }
}

// From any face, on a map with a bay, where a walk from face to face ends at the boundary.
TEST(FlatMapLocation, AFaceToStartFromChangesNothing)
{
  const TriangleMesh whole = rectangleGrid(11, 11, 2.0);
  std::set<int> bay;
  for (int f = 0; f < whole.faceCount(); ++f)
  {
    const Eigen::RowVector3d centre =
      (whole.Vertices.row(whole.Faces(f, 0)) + whole.Vertices.row(whole.Faces(f, 1)) +
        whole.Vertices.row(whole.Faces(f, 2))) /
      3.0;
    if (centre.x() > -0.8 && std::abs(centre.y()) < 0.3)
    {
      bay.insert(f);
    }
  }
  const TriangleMesh sheet = withoutFaces(whole, bay);
  const FlatMapLocation location(sheet, sheet.Vertices.leftCols<2>());
  RandomNumbers random(3);
  int inside = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Eigen::RowVector2d point(random.real(-1.2, 1.2), random.real(-1.0, 1.0));
    const MapPlace place = location.onMap(point);
    const MapPlace walked = location.onMap(point, random.integer(0, sheet.faceCount() - 1));
    EXPECT_EQ(walked.Face, place.Face);
    EXPECT_EQ(walked.Inside, place.Inside);
    EXPECT_NEAR(walked.Distance, place.Distance, 1e-15);
    EXPECT_LT((location.mapPoint(walked) - location.mapPoint(place)).norm(), 1e-15);
    inside += place.Inside;
  }
  EXPECT_GT(inside, 500);
  EXPECT_LT(inside, 1500);
}

TEST(FlatMapLocation, BeyondTheBoundaryTheNearestPlaceIsToldAndHowFarItIs)
{
  TriangleMesh sheet = rectangleGrid(5, 5, 2.0);
  const Points2 flat = sheet.Vertices.leftCols<2>();
  sheet.Vertices *= 10.0;
  const FlatMapLocation location(sheet, flat);
  const MapPlace beyond = location.onMap({ 1.25, 0.125 });
  EXPECT_FALSE(beyond.Inside);
  EXPECT_DOUBLE_EQ(beyond.Distance, 0.25);
  EXPECT_LT((location.mapPoint(beyond) - Eigen::RowVector2d(1.0, 0.125)).norm(), 1e-15);
  EXPECT_LT((location.surfacePoint(beyond) - Eigen::RowVector3d(10.0, 1.25, 0.0)).norm(), 1e-14);
  const MapPlace above = location.onSurface({ 5.0, 1.0, 3.0 });
  EXPECT_FALSE(above.Inside);
  EXPECT_DOUBLE_EQ(above.Distance, 3.0);
}

TEST(FlatMapLocation, FacesWithoutAreaAreNeverTheAnswer)
{
  // The second face is a line; the third is flat on the map only.
  const TriangleMesh surface =
    meshOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 2, 2, 5 } },
      { { 0, 1, 2 }, { 1, 1, 2 }, { 1, 3, 4 } });
  Points2 flat(5, 2);
  flat << 0, 0, 1, 0, 0, 1, 0.5, 0.5, 0, 1;
  const FlatMapLocation location(surface, flat);
  const MapPlace place = location.onMap({ 0.5, 0.5 });
  EXPECT_EQ(place.Face, 0);
  EXPECT_TRUE(place.Inside);
  EXPECT_EQ(location.onSurface({ 2, 2, 5 }).Face, 2);
}

TEST(FlatMapLocation, NamesWhatIsWrong)
{
  const TriangleMesh square = rectangleGrid(4, 4, 2.0);
  const Points2 flat = square.Vertices.leftCols<2>();
  EXPECT_TRUE(contains(
    messageOf<InvalidInput>([&] { FlatMapLocation(square, flat.topRows(3)); }), "3 flat positions"));
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { FlatMapLocation(square, Points2::Zero(flat.rows(), 2)); }),
      "no area"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Points2 broken = flat;
  broken(3, 1) = nan;
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { FlatMapLocation(square, broken); }), "not finite"));
  const FlatMapLocation location(square, flat);
  EXPECT_TRUE(contains(messageOf<InvalidInput>([&] { location.onMap({ nan, 0 }); }), "not finite"));
  EXPECT_THROW(location.onSurface({ 0, 0, nan }), InvalidInput);
}

} // namespace
