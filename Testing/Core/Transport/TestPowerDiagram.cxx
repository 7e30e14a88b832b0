// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Errors.h"
#include "Transport/PowerDiagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace
{

using namespace flattening;
using Weights = PowerDiagram::Weights;
using Polygon = std::vector<Eigen::Vector2d>;

constexpr double Pi = EIGEN_PI;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

double polygonArea(const Polygon& polygon)
{
  double area = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    area += 0.5 * cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  }
  return area;
}

Eigen::Vector2d polygonCentroid(const Polygon& polygon)
{
  Eigen::Vector2d moment(0.0, 0.0);
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    const Eigen::Vector2d& a = polygon[k];
    const Eigen::Vector2d& b = polygon[(k + 1) % polygon.size()];
    moment += cross(a, b) / 6.0 * (a + b);
  }
  return moment / polygonArea(polygon);
}

// The part of a convex polygon where normal . x <= bound.
Polygon clipped(const Polygon& polygon, const Eigen::Vector2d& normal, double bound)
{
  Polygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    const Eigen::Vector2d& a = polygon[k];
    const Eigen::Vector2d& b = polygon[(k + 1) % polygon.size()];
    const double da = normal.dot(a) - bound;
    const double db = normal.dot(b) - bound;
    if (da <= 0.0)
    {
      result.push_back(a);
    }
    if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0))
    {
      result.push_back(a + da / (da - db) * (b - a));
    }
  }
  return result;
}

// The circle as a fine polygon of the right area.
constexpr int CircleSides = 100000;
Polygon circle()
{
  Polygon polygon;
  const double radius = std::sqrt(2.0 * Pi / (CircleSides * std::sin(2.0 * Pi / CircleSides)));
  for (int k = 0; k < CircleSides; ++k)
  {
    polygon.emplace_back(
      radius * std::cos(2.0 * Pi * k / CircleSides), radius * std::sin(2.0 * Pi * k / CircleSides));
  }
  return polygon;
}

// By definition: the domain cut by one half-plane per other site.
Polygon cellByHalfPlanes(const Points2& sites, const Weights& weights, int site, Polygon cell)
{
  const Eigen::Vector2d here = sites.row(site);
  for (int j = 0; j < sites.rows() && !cell.empty(); ++j)
  {
    if (j != site)
    {
      const Eigen::Vector2d there = sites.row(j);
      const double bound = 0.5 * (there.squaredNorm() - here.squaredNorm() -
                                   static_cast<double>(weights[j] - weights[site]));
      cell = clipped(cell, there - here, bound);
    }
  }
  return cell;
}

Points2 randomSites(int n, unsigned seed, double radius = 1.0)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Points2 sites(n, 2);
  for (int i = 0; i < n; ++i)
  {
    const double r = radius * std::sqrt(uniform(random));
    const double angle = 2.0 * Pi * uniform(random);
    sites.row(i) << r * std::cos(angle), r * std::sin(angle);
  }
  return sites;
}

// Weights of a convex function at the sites leave no cell empty: w = |y|^2 - 2 h.
Weights convexWeights(const Points2& sites)
{
  Weights weights(sites.rows());
  for (int i = 0; i < sites.rows(); ++i)
  {
    const double x = sites(i, 0);
    const double y = sites(i, 1);
    weights[i] = x * x + y * y - 2.0 * (0.4 * x * x + 0.25 * y * y + 0.05 * x * x * x * x + 0.1 * x);
  }
  return weights;
}

void expectCellsByDefinition(const PowerDiagram& diagram, const Weights& weights)
{
  for (int i = 0; i < diagram.siteCount(); ++i)
  {
    const Polygon cell = cellByHalfPlanes(diagram.sites(), weights, i, circle());
    const double area = cell.size() > 2 ? polygonArea(cell) : 0.0;
    EXPECT_NEAR(diagram.areas()[i], area, 2e-9) << i;
    if (area > 1e-4)
    {
      EXPECT_LT((diagram.centroids().row(i).transpose() - polygonCentroid(cell)).norm(), 1e-7) << i;
    }
  }
}

// The cells make up the disk: what holds to rounding.
void expectPartition(const PowerDiagram& diagram)
{
  EXPECT_NEAR(diagram.areas().sum(), Pi, 1e-12);
  EXPECT_GE(diagram.areas().minCoeff(), -1e-15);
  // The centroid of the whole is the origin.
  EXPECT_LT((diagram.areas().transpose() * diagram.centroids()).norm(), 1e-12);
}

TEST(PowerDiagram, CellsAreIntersectionsOfHalfPlanes)
{
  const Points2 sites = randomSites(60, 1);
  PowerDiagram diagram(sites);
  for (const Weights& weights : { Weights(Weights::Zero(60)), convexWeights(sites) })
  {
    ASSERT_TRUE(diagram.update(weights));
    expectPartition(diagram);
    expectCellsByDefinition(diagram, weights);
  }
  EXPECT_EQ(diagram.updates(), 2);
}

TEST(PowerDiagram, SumsToTheDiskWithManySites)
{
  const Points2 sites = randomSites(20000, 2);
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(Weights::Zero(20000)));
  expectPartition(diagram);
  ASSERT_TRUE(diagram.update(convexWeights(sites)));
  expectPartition(diagram);
}

// Without weights a point belongs to its nearest site.
TEST(PowerDiagram, ZeroWeightsAreVoronoi)
{
  const Points2 sites = randomSites(300, 3);
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(Weights::Zero(300)));
  for (int i = 0; i < 300; ++i)
  {
    const Polygon outline = diagram.outline(i, 0.01);
    for (const Eigen::Vector2d& corner : outline)
    {
      const double nearest = (sites.rowwise() - corner.transpose()).rowwise().norm().minCoeff();
      EXPECT_NEAR((sites.row(i).transpose() - corner).norm(), nearest, 1e-11) << i;
    }
  }
}

TEST(PowerDiagram, OutlinesHaveTheCellsAreas)
{
  const Points2 sites = randomSites(200, 4);
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(convexWeights(sites)));
  double sum = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    const Polygon outline = diagram.outline(i, 1e-4); // sagitta 1e-9
    EXPECT_NEAR(outline.empty() ? 0.0 : polygonArea(outline), diagram.areas()[i], 1e-8) << i;
    const double arc = diagram.boundaryPart(i).Length;
    EXPECT_GE(arc, 0.0);
    sum += arc;
  }
  EXPECT_NEAR(sum, 2.0 * Pi, 1e-12) << "the arcs make the circle";
}

// Counter-clockwise; sites lie inside and outside of it.
Points2 pentagon()
{
  Points2 corners(5, 2);
  corners << -0.7, -0.6, 0.8, -0.7, 0.9, 0.1, 0.1, 0.8, -0.8, 0.3;
  return corners;
}

TEST(PowerDiagram, CellsInAPolygonAreIntersectionsOfHalfPlanes)
{
  const Points2 corners = pentagon();
  Polygon polygon;
  for (int k = 0; k < 5; ++k)
  {
    polygon.emplace_back(corners.row(k));
  }
  for (const int n : { 3, 4, 8, 60, 400 })
  {
    const Points2 sites = randomSites(n, n, 1.2);
    PowerDiagram diagram(sites, std::make_shared<ConvexPolygon>(corners));
    const Weights weights = convexWeights(sites);
    ASSERT_TRUE(diagram.update(weights));
    EXPECT_NEAR(diagram.areas().sum(), polygonArea(polygon), 1e-13);
    double boundary = 0.0;
    for (int i = 0; i < n; ++i)
    {
      const Polygon cell = cellByHalfPlanes(sites, weights, i, polygon);
      const double area = cell.size() > 2 ? polygonArea(cell) : 0.0;
      EXPECT_NEAR(diagram.areas()[i], area, 1e-14) << i;
      if (area > 1e-6)
      {
        EXPECT_LT((diagram.centroids().row(i).transpose() - polygonCentroid(cell)).norm(), 1e-9) << i;
        const Polygon outline = diagram.outline(i, 0.1);
        EXPECT_NEAR(polygonArea(outline), area, 1e-14) << i;
      }
      boundary += diagram.boundaryPart(i).Length;
    }
    // If a cell has several parts of the boundary, the longest counts.
    EXPECT_LE(boundary, diagram.domain().perimeter() + 1e-12);
    EXPECT_GT(boundary, 0.8 * diagram.domain().perimeter());
  }
}

TEST(ConvexPolygon, ParametersAreLengthsAlongTheBoundary)
{
  const ConvexPolygon domain(pentagon());
  const Points2 corners = pentagon();
  double along = 0.0;
  for (int k = 0; k < 5; ++k)
  {
    const Eigen::Vector2d corner = corners.row(k);
    const Eigen::Vector2d following = corners.row((k + 1) % 5);
    EXPECT_LT((domain.at(along) - corner).norm(), 1e-14);
    EXPECT_LT((domain.at(along + 3.0 * domain.perimeter()) - corner).norm(), 1e-13);
    const Eigen::Vector2d between = 0.3 * corner + 0.7 * following;
    const double place = along + 0.7 * (following - corner).norm();
    EXPECT_NEAR(domain.parameterOf(between), place, 1e-13);
    EXPECT_NEAR(
      domain.parameterOf(domain.centroid() + 0.4 * (between - domain.centroid())), place, 1e-13);
    EXPECT_NEAR(domain.distanceAlong(domain.at(place - 0.2), domain.at(place + 0.3)), 0.5, 1e-13);
    EXPECT_NEAR(domain.distanceAlong(domain.at(place + 0.3), domain.at(place - 0.2)),
      domain.perimeter() - 0.5,
      1e-13);
    EXPECT_EQ(domain.distanceAlong(between, between), 0.0);
    along += (following - corner).norm();
  }
  EXPECT_NEAR(domain.perimeter(), along, 1e-14);
  ConvexDomain::Chord chord{};
  EXPECT_FALSE(domain.cross({ 0.0, 0.9 }, { 1.0, 0.0 }, chord));
  ASSERT_TRUE(domain.cross({ 5.0, 0.0 }, { 1.0, 0.0 }, chord));
  EXPECT_NEAR(chord.Enter.y(), 0.0, 1e-15);
  EXPECT_NEAR(chord.LeaveAt - chord.EnterAt, (chord.Leave - chord.Enter).norm(), 1e-14);
  EXPECT_LT(chord.LeaveAt, 0.0);
}

TEST(ConvexPolygon, RefusesWhatIsNotConvex)
{
  Points2 corners = pentagon();
  corners.row(3) << 0.3, 0.0;
  EXPECT_THROW(ConvexPolygon{ corners }, InvalidInput) << "a dent";
  EXPECT_THROW(ConvexPolygon{ pentagon().colwise().reverse() }, InvalidInput) << "clockwise";
  EXPECT_THROW(ConvexPolygon{ pentagon().topRows(2) }, InvalidInput);
  Points2 star(5, 2);
  for (int k = 0; k < 5; ++k)
  {
    star.row(k) << std::cos(0.8 * Pi * k), std::sin(0.8 * Pi * k);
  }
  EXPECT_THROW(ConvexPolygon{ star }, InvalidInput) << "a pentagram turns around twice";
  corners = pentagon();
  corners(2, 0) = NAN;
  EXPECT_THROW(ConvexPolygon{ corners }, InvalidInput);
}

// dA_i / dw_j = -length / (2 distance), the paper's Hessian; the diagonal is minus the row's sum.
TEST(PowerDiagram, DerivativesOfTheAreas)
{
  constexpr int n = 80;
  const Points2 sites = randomSites(n, 5);
  const Weights weights = convexWeights(sites);
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(weights));
  Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(n, n);
  for (const PowerDiagram::CommonSide& side : diagram.commonSides())
  {
    const double value = side.Length / (2.0 * side.Distance);
    EXPECT_NEAR(side.Distance, (sites.row(side.First) - sites.row(side.Second)).norm(), 1e-15);
    derivative(side.First, side.Second) -= value;
    derivative(side.Second, side.First) -= value;
    derivative(side.First, side.First) += value;
    derivative(side.Second, side.Second) += value;
  }
  const double h = 1e-7;
  for (int j = 0; j < n; ++j)
  {
    Weights moved = weights;
    moved[j] += h;
    ASSERT_TRUE(diagram.update(moved));
    const Eigen::VectorXd after = diagram.areas();
    moved[j] -= 2.0L * h;
    ASSERT_TRUE(diagram.update(moved));
    const Eigen::VectorXd difference = (after - diagram.areas()) / (2.0 * h);
    EXPECT_LT((difference - derivative.col(j)).cwiseAbs().maxCoeff(), 1e-5) << j;
  }
}

TEST(PowerDiagram, ACommonConstantChangesNothing)
{
  const Points2 sites = randomSites(100, 6);
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(convexWeights(sites)));
  const Eigen::VectorXd areas = diagram.areas();
  ASSERT_TRUE(diagram.update((convexWeights(sites).array() + DoubleDouble(3.0)).matrix()));
  EXPECT_LT((diagram.areas() - areas).cwiseAbs().maxCoeff(), 1e-13);
}

// Three sites at 120 degrees: three sectors. A weight of the first one moves the lines between them.
TEST(PowerDiagram, ThreeSectors)
{
  Points2 sites(3, 2);
  for (int k = 0; k < 3; ++k)
  {
    sites.row(k) << 0.5 * std::cos(2.0 * Pi * k / 3.0), 0.5 * std::sin(2.0 * Pi * k / 3.0);
  }
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(Weights::Zero(3)));
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(diagram.areas()[k], Pi / 3.0, 1e-15);
    EXPECT_NEAR(diagram.boundaryPart(k).Length, 2.0 * Pi / 3.0, 1e-14);
    EXPECT_NEAR(
      std::remainder(diagram.boundaryPart(k).Middle - 2.0 * Pi * k / 3.0, 2.0 * Pi), 0.0, 1e-14);
    // The centroid of a sector of half-angle a is at 2 sin(a) / (3 a).
    const double radius = 2.0 * std::sin(Pi / 3.0) / (3.0 * Pi / 3.0);
    EXPECT_NEAR(diagram.centroids().row(k).norm(), radius, 1e-15);
  }
}

// Three sites nearly on a line: two circular segments and what is between them.
TEST(PowerDiagram, SegmentsOfTheCircle)
{
  Points2 sites(3, 2);
  sites << -0.5, 0.0, 0.0, 1e-9, 0.5, 0.0;
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(Weights::Zero(3)));
  const double segment = std::acos(0.25) - 0.25 * std::sqrt(1.0 - 0.25 * 0.25);
  EXPECT_NEAR(diagram.areas()[0], segment, 1e-8);
  EXPECT_NEAR(diagram.areas()[2], segment, 1e-8);
  EXPECT_NEAR(diagram.boundaryPart(0).Length, 2.0 * std::acos(0.25), 1e-8);
  EXPECT_NEAR(diagram.boundaryPart(1).Length, Pi - 2.0 * std::acos(0.25), 1e-8) << "one of its two arcs";
  expectPartition(diagram);
}

TEST(PowerDiagram, OneCellMayCoverTheDisk)
{
  // Their bisectors with the first site pass at a distance of 1.5 from the centre.
  Points2 sites(4, 2);
  sites << 0.0, 0.0, 3.0, 0.0, -2.0, 2.3, -2.0, -2.3;
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(Weights::Zero(4)));
  EXPECT_EQ(diagram.areas()[0], Pi);
  EXPECT_EQ(diagram.centroids().row(0).norm(), 0.0);
  EXPECT_EQ(diagram.areas().tail(3).sum(), 0.0);
  EXPECT_EQ(diagram.centroids().row(1), sites.row(1)) << "of a cell outside: the site";
  EXPECT_TRUE(diagram.outline(1, 0.1).empty());
  EXPECT_TRUE(diagram.commonSides().empty());
  EXPECT_NEAR(polygonArea(diagram.outline(0, 1e-4)), Pi, 1e-8);
}

// A heavy neighbour pushes a cell away from its own site; the cell stays what the half-planes say.
TEST(PowerDiagram, ASiteMayLieOutsideOfItsCell)
{
  Points2 sites(5, 2);
  sites << 0.0, 0.0, 0.4, 0.0, -0.4, 0.1, 0.1, 0.5, 0.0, -0.5;
  Weights weights(5);
  weights << 0.2, 0.0, 0.0, 0.0, 0.0;
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(weights));
  expectPartition(diagram);
  expectCellsByDefinition(diagram, weights);
  // The line between sites 0 and 1 is at x = (0.16 + 0.2) / 0.8, right of site 1.
  const Polygon outline = diagram.outline(1, 0.01);
  for (const Eigen::Vector2d& corner : outline)
  {
    EXPECT_GE(corner.x(), 0.45 - 1e-12);
  }
}

TEST(PowerDiagram, AHiddenSiteIsReported)
{
  const Points2 sites = randomSites(50, 8);
  PowerDiagram diagram(sites);
  Weights weights = Weights::Zero(50);
  weights[17] = -1.0;
  EXPECT_FALSE(diagram.update(weights));
  EXPECT_TRUE(diagram.update(Weights::Zero(50))) << "usable afterwards";
  expectPartition(diagram);
}

TEST(PowerDiagram, HiddenSitesSayWhatTheyLack)
{
  Points2 sites = randomSites(50, 6);
  sites.row(17) << 0.1, 0.2;
  sites.row(31) << -0.3, 0.1;
  PowerDiagram diagram(sites);
  Weights weights = Weights::Zero(50);
  weights[17] = -1.0;
  weights[31] = -0.5;
  EXPECT_FALSE(diagram.update(weights, 1));
  ASSERT_TRUE(diagram.update(weights, 2));
  expectPartition(diagram);
  EXPECT_EQ(diagram.areas()[17], 0.0);
  EXPECT_EQ(diagram.areas()[31], 0.0);
  const std::vector<PowerDiagram::HiddenSite> hidden = diagram.hiddenSites();
  ASSERT_EQ(hidden.size(), 2u);
  for (const PowerDiagram::HiddenSite& site : hidden)
  {
    Weights raised = weights;
    raised[site.Site] += (1.0 - 1e-9) * site.Lacking;
    ASSERT_TRUE(diagram.update(raised, 2));
    EXPECT_EQ(diagram.hiddenSites().size(), 2u) << site.Site;
    raised[site.Site] += 2e-9 * site.Lacking;
    ASSERT_TRUE(diagram.update(raised, 2));
    EXPECT_EQ(diagram.hiddenSites().size(), 1u) << site.Site;
  }
}

// Two sites a few last digits of a double apart share the disk along the line that their weights'
// difference of less than 1e-15 places; a double of the weights' size has the last digit 1e-17.
TEST(PowerDiagram, WeightsBeyondDoublePlaceTheSides)
{
  const double distance = std::ldexp(1.0, -50);
  Points2 sites(3, 2);
  sites << -0.5 * distance, 0.0, 0.5 * distance, 0.0, 0.0, -0.9;
  for (const double place : { -0.3, 0.0, 0.1, 0.7 })
  {
    Weights weights(3);
    weights << DoubleDouble(0.1) + 2.0 * distance * place, 0.1, -5.0;
    PowerDiagram diagram(sites);
    ASSERT_TRUE(diagram.update(weights));
    const double beyond = std::acos(place) - place * std::sqrt(1.0 - place * place);
    EXPECT_NEAR(diagram.areas()[1], beyond, 1e-12) << place;
    EXPECT_NEAR(diagram.areas()[0], Pi - beyond, 1e-12) << place;
  }
}

// Pairs of sites at a distance of 1e-9.
TEST(PowerDiagram, NearlyCoincidentSites)
{
  Points2 sites = randomSites(200, 9, 0.95);
  for (int i = 0; i < 100; ++i)
  {
    sites.row(100 + i) = sites.row(i) + Eigen::RowVector2d(1e-9, 5e-10);
  }
  PowerDiagram diagram(sites);
  ASSERT_TRUE(diagram.update(Weights::Zero(200)));
  expectPartition(diagram);
}

} // namespace
