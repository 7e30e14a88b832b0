// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Areas/AreaPreservingDisk.h"
#include "Conformal/ConformalDisk.h"
#include "FlatMap/DistortionSummary.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshTopology.h"
#include "Support/SampleSurfaces.h"
#include "Transport/BoundaryPlacement.h"
#include "Transport/DomainPolygon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace
{

using namespace flattening;
using namespace flattening::analytic;
using samples::contains;
using samples::messageOf;
using samples::Pi;
using samples::rectangleGrid;

Points2 pointsOf(const std::vector<Eigen::RowVector2d>& points)
{
  Points2 result(points.size(), 2);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    result.row(static_cast<Eigen::Index>(k)) = points[k];
  }
  return result;
}

Points2 regular(int corners)
{
  Points2 result(corners, 2);
  for (int k = 0; k < corners; ++k)
  {
    result.row(k) << std::cos(2.0 * Pi * k / corners), std::sin(2.0 * Pi * k / corners);
  }
  return result;
}

struct Case
{
  const char* Name;
  Points2 Outline;
  double Within; // percent of the faces within 2 %
};

// The name of a case in the names of its tests.
void PrintTo(const Case& value, std::ostream* stream)
{
  *stream << value.Name;
}

class AreaPreservingPolygonOf : public testing::TestWithParam<Case>
{
};

// Twice what the boundary encloses.
double enclosed(const Points2& positions, const std::vector<int>& loop)
{
  double twice = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const Eigen::RowVector2d a = positions.row(loop[k]);
    const Eigen::RowVector2d b = positions.row(loop[(k + 1) % loop.size()]);
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice;
}

double longestSide(const Points2& positions, const std::vector<int>& loop)
{
  double longest = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const int next = loop[(k + 1) % loop.size()];
    longest = std::max(longest, (positions.row(next) - positions.row(loop[k])).norm());
  }
  return longest;
}

// The largest area that edges of a given length cut off from all corners: isosceles triangles.
double largestCutOff(const Points2& corners, double side)
{
  double area = 0.0;
  const Eigen::Index n = corners.rows();
  for (Eigen::Index k = 0; k < n; ++k)
  {
    const Eigen::RowVector2d a = (corners.row((k + 1) % n) - corners.row(k)).normalized();
    const Eigen::RowVector2d b = (corners.row((k + n - 1) % n) - corners.row(k)).normalized();
    area += 0.25 * side * side / std::tan(0.5 * std::acos(a.dot(b)));
  }
  return area;
}

TEST_P(AreaPreservingPolygonOf, IsFilledAndFacesKeepTheirAreas)
{
  const TriangleMesh mesh = ringMesh(sphericalCap(0.5 * Pi), 3000).Mesh;
  const std::vector<int> loop = requireDisk(mesh);
  const Points2 conformal = conformalDiskMap(mesh).Positions;
  const Points2 corners = domainPolygon(GetParam().Outline).Corners;
  const ConvexPolygon polygon(corners);
  for (const bool fixed : { false, true })
  {
    const AreaPreservingMap map =
      areaPreservingPolygonMap(mesh, conformal, UnitDisk(), { corners, fixed }).Map;
    EXPECT_NEAR(map.CellAreas.sum(), Pi, 1e-12);
    EXPECT_LE(map.MaxCellError, 1e-6);
    EXPECT_LE(
      ((map.CellAreas - map.TargetAreas).array() / map.TargetAreas.array()).abs().maxCoeff(), 1e-6);
    EXPECT_TRUE(map.Bijective);
    EXPECT_EQ(countFlippedFaces(map.Positions, mesh.Faces), 0);
    const DistortionSummary summary = summariseDistortion(measureDistortion(mesh, map.Positions));
    std::cout << "faces within 2 %: " << summary.FacesWithin2Percent << ", mean angle error "
              << summary[Measure::AngleError].Mean << "\n";
    EXPECT_GT(summary.FacesWithin2Percent, GetParam().Within);
    for (const int v : loop)
    {
      const Eigen::Vector2d position = map.Positions.row(v);
      ASSERT_LT((polygon.at(polygon.parameterOf(position)) - position).norm(), 1e-14) << "on a side";
    }
    for (Eigen::Index k = 0; k < corners.rows(); ++k)
    {
      const double nearest = (map.Positions.rowwise() - corners.row(k)).rowwise().norm().minCoeff();
      EXPECT_TRUE(fixed ? nearest < 1e-14 : nearest > 1e-6) << nearest;
    }
    // Without vertices in the corners these are cut off.
    EXPECT_NEAR(enclosed(map.Positions, loop),
      2.0 * Pi,
      fixed ? 1e-12 : 2.0 * largestCutOff(corners, longestSide(map.Positions, loop)));
    EXPECT_TRUE(fixed || enclosed(map.Positions, loop) < 2.0 * Pi - 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(,
  AreaPreservingPolygonOf,
  testing::Values(Case{ "Square", pointsOf({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }), 99.5 },
    Case{ "Triangle", pointsOf({ { 0, 0 }, { 3, 0 }, { 1, 2 } }), 99.0 },
    Case{ "Hexagon", regular(6), 99.5 },
    Case{ "ThinQuadrilateral", pointsOf({ { 0, 0 }, { 10, 0.2 }, { 9.5, 1 }, { 0.5, 1.1 } }), 99.0 },
    Case{ "ThinnerQuadrilateral",
      pointsOf({ { 0, 0 }, { 30, 0.2 }, { 29.5, 1 }, { 0.5, 1.1 } }),
      99.0 }),
  [](const testing::TestParamInfo<Case>& info) { return std::string(info.param.Name); });

// How the disk is turned decides where the refinement divides the map, and which long rows of faces
// cross from one part into the other.
TEST(AreaPreservingPolygon, AThinOneIsFilledHoweverTheDiskIsTurned)
{
  const TriangleMesh mesh = ringMesh(sphericalCap(0.5 * Pi), 3000).Mesh;
  const Points2 conformal = conformalDiskMap(mesh).Positions;
  const Points2 corners =
    domainPolygon(pointsOf({ { 0, 0 }, { 30, 0.2 }, { 29.5, 1 }, { 0.5, 1.1 } })).Corners;
  for (const double angle : { 0.2, 0.8, 1.3, 2.0, 2.9 })
  {
    const Points2 turned = conformal * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose();
    const AreaPreservingMap map =
      areaPreservingPolygonMap(mesh, turned, UnitDisk(), { corners, false }).Map;
    EXPECT_TRUE(map.Bijective) << angle;
    const double within =
      summariseDistortion(measureDistortion(mesh, map.Positions)).FacesWithin2Percent;
    std::cout << "turned by " << angle << ", faces within 2 %: " << within << "\n";
    EXPECT_GT(within, 99.3) << angle;
  }
}

// Between rectangles the transport of uniform areas is affine. It is so from sites of any size, and the
// corners of the one go to those of the other.
TEST(AreaPreservingPolygon, RectanglesGoToRectanglesAffinely)
{
  constexpr double width = 2.4;
  const TriangleMesh mesh = rectangleGrid(41, 31, width);
  const Points2 flat = mesh.Vertices.leftCols<2>();
  const auto rectangle = [](double w)
  {
    const double x = 0.5 * w;
    const double y = 0.5 * Pi / w;
    return pointsOf({ { -x, -y }, { x, -y }, { x, y }, { -x, y } });
  };
  for (const double other : { width, 1.2, 6.0 })
  {
    const AreaPreservingMap map =
      areaPreservingPolygonMap(mesh, flat, ConvexPolygon(rectangle(width)), { rectangle(other), true })
        .Map;
    Points2 expected = flat;
    expected.col(0) *= other / width;
    expected.col(1) *= width / other;
    const double largest = (map.Positions - expected).rowwise().norm().maxCoeff();
    std::cout << "greatest distance from the affine map: " << largest << "\n";
    EXPECT_LT(largest, 0.25 * other / 40) << other;
    for (const int corner : { 0, 40, 41 * 30, 41 * 31 - 1 })
    {
      EXPECT_LT((map.Positions.row(corner) - expected.row(corner)).norm(), 1e-14);
    }
  }
}

// A polygon of many sides is nearly a disk.
TEST(AreaPreservingPolygon, ManySidesAreNearlyADisk)
{
  const TriangleMesh mesh = ringMesh(sphericalCap(2.0), 2000).Mesh;
  const Points2 conformal = conformalDiskMap(mesh).Positions;
  AreaPreservingOptions transportAlone;
  transportAlone.RefineFaces = false;
  const Points2 disk = areaPreservingDiskMap(mesh, conformal, {}, transportAlone).Map.Positions;
  const Points2 corners = domainPolygon(regular(1000)).Corners;
  const Points2 polygon =
    areaPreservingPolygonMap(mesh, conformal, UnitDisk(), { corners, false }, {}, transportAlone)
      .Map.Positions;
  EXPECT_LT((disk - polygon).rowwise().norm().maxCoeff(), 1e-4);
}

TEST(AreaPreservingPolygon, RefusesMoreCornersThanBoundaryPoints)
{
  const TriangleMesh mesh = rectangleGrid(4, 3, 2.0); // 10 boundary vertices
  const Points2 conformal = conformalDiskMap(mesh).Positions;
  const auto map = [&](int corners)
  {
    return areaPreservingPolygonMap(
      mesh, conformal, UnitDisk(), { domainPolygon(regular(corners)).Corners, true })
      .Map;
  };
  EXPECT_TRUE(map(10).Bijective);
  const std::string message = messageOf<InvalidInput>([&] { map(11); });
  EXPECT_TRUE(contains(message, "has 10 points, the domain 11 corners: turn Fix Corners off"))
    << message;
}

TEST(AreaPreservingPolygon, RefusesWhatIsNoMapToItsSource)
{
  const TriangleMesh mesh = rectangleGrid(11, 6, 2.0);
  const Points2 flat = mesh.Vertices.leftCols<2>();
  const PolygonTarget target{ domainPolygon(regular(5)).Corners, false };
  EXPECT_TRUE(
    contains(messageOf<InvalidInput>([&] { areaPreservingPolygonMap(mesh, flat, UnitDisk(), target); }),
      "run Conformal Disk first"));
}

// Five sites on the sides of a square, whose cells have its corners at the parameters 0, 2, 4 and 6.
TEST(CornerMembers, HaveTheCornersInTheirCells)
{
  const Points2 square = pointsOf({ { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } });
  PowerDiagram diagram(pointsOf({ { 0.9, 0 }, { 2, 0.3 }, { 2, 2 }, { 0.1, 2 }, { 0, 0.8 } }),
    std::make_shared<ConvexPolygon>(square));
  ASSERT_TRUE(diagram.update(PowerDiagram::Weights::Zero(5)));
  const std::vector<int> sites{ 0, 1, 2, 3, 4 };
  const auto members = [&](const std::vector<int>& loop, const std::vector<double>& places)
  { return cornerMembers(diagram, loop, sites, places); };
  using Members = std::vector<int>;
  EXPECT_EQ(members({ 0, 1, 2, 3, 4 }, { 0.0, 2.0, 4.0, 6.0 }), (Members{ 4, 1, 2, 3 }));
  EXPECT_EQ(members({ 2, 3, 4, 0, 1 }, { 0.0, 2.0, 4.0, 6.0 }), (Members{ 2, 4, 0, 1 }));
  EXPECT_EQ(members({ 0, 1, 2, 3, 4 }, { 3.9, 4.0, 4.1 }), (Members{ 2, 3, 4 })) << "each its own";
  EXPECT_EQ(members({ 0, 1, 2, 3, 4 }, { 0.1, 0.2, 0.3, 0.4, 0.5 }), (Members{ 0, 1, 2, 3, 4 }));
}

TEST(DomainPolygon, HasAreaPiAroundItsCentroid)
{
  const Points2 square = pointsOf({ { 5, 5 }, { 9, 5 }, { 9, 9 }, { 5, 9 } });
  // Clockwise; closed, with a point in the middle of a side and one twice.
  const Points2 other =
    pointsOf({ { 5, 5 }, { 5, 9 }, { 9, 9 }, { 9, 9 }, { 9, 7 }, { 9, 5 }, { 5, 5 } });
  for (const Points2& outline : { square, other })
  {
    const DomainPolygon polygon = domainPolygon(outline);
    ASSERT_EQ(polygon.Corners.rows(), 4);
    const ConvexPolygon domain(polygon.Corners); // throws if clockwise
    EXPECT_NEAR(domain.area(), Pi, 1e-14);
    EXPECT_LT(domain.centroid().norm(), 1e-15);
    EXPECT_NEAR(domain.innerRadius(), 0.5 * std::sqrt(Pi), 1e-15);
    EXPECT_LT((polygon.Centroid - Eigen::Vector2d(7, 7)).norm(), 1e-14);
    EXPECT_NEAR(polygon.Scale, std::sqrt(16.0 / Pi), 1e-14);
  }
}

TEST(DomainPolygon, TheSizeOfTheOutlineDoesNotMatter)
{
  const Points2 outline = pointsOf({ { 1, 0.3 }, { 4, 0.5 }, { 3, 2.7 }, { 1.2, 2 } });
  const DomainPolygon expected = domainPolygon(outline);
  for (const int exponent : { -1000, -350, 350, 1000 })
  {
    const double scale = std::ldexp(1.0, exponent);
    const DomainPolygon polygon = domainPolygon(scale * outline);
    EXPECT_EQ(polygon.Corners, expected.Corners);
    EXPECT_EQ(polygon.Centroid, scale * expected.Centroid);
    EXPECT_EQ(polygon.Scale, scale * expected.Scale);
  }
}

// A point is no corner if it is near the line through its neighbours, beside the width. Measured by the
// angle there, some points of a needle would be none, and its area would be another.
TEST(DomainPolygon, KeepsTheAreaOfANeedle)
{
  constexpr int points = 20000;
  for (const double width : { 1e-1, 1e-3, 2e-6 })
  {
    Points2 outline = regular(points);
    const double area = width * 0.5 * points * std::sin(2.0 * Pi / points); // triangles at the centre
    outline.col(1) *= width;
    EXPECT_NEAR(domainPolygon(outline).Scale / std::sqrt(area / Pi), 1.0, 1e-9) << width;
  }
}

TEST(DomainPolygon, RefusesWhatIsNoConvexPolygon)
{
  const auto message = [](const Points2& outline)
  { return messageOf<InvalidInput>([&outline] { domainPolygon(outline); }); };
  EXPECT_TRUE(contains(message(pointsOf({ { 0, 0 }, { 1, 0 } })), "has 2 points"));
  EXPECT_TRUE(contains(message(pointsOf({ { 0, 0 }, { 1, 0 }, { 2, 0 } })), "no area"));
  EXPECT_TRUE(contains(message(pointsOf({ { 1, 1 }, { 1, 1 }, { 1, 1 } })), "extent of 0"));
  EXPECT_TRUE(contains(message(pointsOf({ { 0, 0 }, { 1, 0 }, { 1, 1e-12 } })), "no area"));
  EXPECT_TRUE(contains(message(pointsOf({ { 0, 0 }, { 2, 0 }, { 0.5, 0.5 }, { 0, 2 } })), "not convex"))
    << "a dart";
  EXPECT_TRUE(contains(message(pointsOf({ { 0, 0 }, { 3, 0 }, { 1, 2 }, { 2, 2 } })), "crosses itself"))
    << "crosses itself";
  Points2 star(5, 2);
  for (int k = 0; k < 5; ++k)
  {
    star.row(k) = regular(5).row(2 * k % 5);
  }
  EXPECT_TRUE(contains(message(star), "not convex, or crosses itself"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(message(pointsOf({ { 0, 0 }, { 1, nan }, { 1, 1 } })), "point 1"));
  EXPECT_TRUE(contains(message(pointsOf({ { 1e12, 0 }, { 1e12 + 1, 0 }, { 1e12, 1 } })), "too small"));
  Points2 needle = regular(4);
  needle.col(1) *= 1e-7;
  EXPECT_TRUE(contains(message(needle), "a million times as long as wide"));
  EXPECT_TRUE(contains(message(1e-310 * regular(4)), "too small"));
  EXPECT_TRUE(contains(message(1.5e308 * regular(4)), "too large"));
}

TEST(DomainPolygon, FarFromTheOriginNeedsALargeMap)
{
  const DomainPolygon polygon = domainPolygon(1e130 * pointsOf({ { 1, 2 }, { 2, 2 }, { 1, 3 } }));
  const auto message = [&polygon](double radius)
  { return messageOf<InvalidInput>([&] { requireResolved(polygon, radius); }); };
  EXPECT_TRUE(contains(message(5.0), "a distance of 2.33333e+130"));
  EXPECT_TRUE(contains(message(2.3e121), "does not hold so small a map"));
  EXPECT_NO_THROW(requireResolved(polygon, 2.4e121));
  EXPECT_NO_THROW(requireResolved(domainPolygon(regular(6)), 1e-5)) << "around the origin";
}

} // namespace
