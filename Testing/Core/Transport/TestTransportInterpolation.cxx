// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnalyticSurfaces.h"
#include "Mesh/RecursiveBisection.h"
#include "Transport/TransportInterpolation.h"
#include "Transport/TransportSites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace flattening;

Points2 sunflower(int count)
{
  return analytic::sunflowerMesh(analytic::flatDisk(), count).Mesh.Vertices.leftCols<2>();
}

TEST(RecursiveBisection, TakeEveryPointOnceAndAreNeverTooLarge)
{
  const Points2 points = sunflower(5000);
  const auto parts = recursiveBisection(points, 300, 0.7);
  std::vector<int> seen(points.rows(), 0);
  for (const std::vector<int>& part : parts)
  {
    EXPECT_LE(part.size(), 300u);
    EXPECT_GE(part.size(), 100u); // halves of halves
    EXPECT_TRUE(std::is_sorted(part.begin(), part.end()));
    for (const int i : part)
    {
      ++seen[i];
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), points.rows());
  EXPECT_EQ(parts, recursiveBisection(points, 300, 0.7));
  EXPECT_NE(parts, recursiveBisection(points, 300, 0.0));
}

TEST(TransportSites, GroupsHaveTheMassAndTheCentreOfTheirVertices)
{
  const Points2 points = sunflower(2000);
  Eigen::VectorXd masses(points.rows());
  for (Eigen::Index v = 0; v < masses.size(); ++v)
  {
    masses[v] = 1.0 + 0.5 * std::sin(static_cast<double>(v));
  }
  const std::vector<int> alone{ 5, 17, 1999 };
  const Eigen::VectorXd logScales = Eigen::VectorXd::Zero(points.rows());
  const TransportSites sites = groupedSites(points, masses, logScales, alone, 8);
  const Eigen::VectorXd sums = sites.sums(masses);
  EXPECT_NEAR(sums.sum(), masses.sum(), 1e-12 * masses.sum());
  EXPECT_GE(sites.count(), 2000 / 8);
  EXPECT_LE(sites.count(), 2000 / 4);
  for (const int axis : { 0, 1 })
  {
    const Eigen::VectorXd moments = sites.sums(masses.cwiseProduct(points.col(axis)));
    EXPECT_LE((moments - sums.cwiseProduct(sites.Positions.col(axis))).cwiseAbs().maxCoeff(), 1e-14);
  }
  const Eigen::VectorXd counts = sites.sums(Eigen::VectorXd::Ones(points.rows()));
  for (const int v : alone)
  {
    EXPECT_EQ(counts[sites.SiteOfVertex[v]], 1.0);
    EXPECT_EQ(sites.Positions.row(sites.SiteOfVertex[v]), points.row(v));
  }
}

// The scale falls by a factor of a million from x = 0 to x = 0.5, and is the same everywhere else.
TEST(TransportSites, VerticesDoNotShareASiteWhereTheScaleChangesMuch)
{
  const Points2 points = sunflower(2000);
  const Eigen::VectorXd logScales =
    std::log(1e-6) * (points.col(0).array() / 0.5).max(0.0).min(1.0).matrix();
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(points.rows());
  const TransportSites sites = groupedSites(points, ones, logScales, {}, 8);
  const Eigen::VectorXd counts = sites.sums(ones);
  for (Eigen::Index v = 0; v < points.rows(); ++v)
  {
    const double x = points(v, 0);
    if (x > 0.05 && x < 0.45)
    {
      EXPECT_EQ(counts[sites.SiteOfVertex[v]], 1.0) << "at " << x;
    }
    else if (x < -0.15 || x > 0.65)
    {
      EXPECT_GE(counts[sites.SiteOfVertex[v]], 4.0) << "at " << x;
    }
  }
}

// Points whose places are known to few digits share their sites as if the scale were the same.
TEST(TransportSites, VerticesThatDoublesHardlyTellApartShareASite)
{
  const Points2 points = 1e-14 * sunflower(2000);
  const Eigen::VectorXd logScales = std::log(1e-6) * 1e14 * points.col(0);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(points.rows());
  EXPECT_LE(groupedSites(points, ones, logScales, {}, 8).count(), 2000 / 4);
  EXPECT_GE(groupedSites(1e3 * points, ones, logScales, {}, 8).count(), 2000 / 2);
}

TEST(TransportSites, VerticesAtOnePlaceAreOneSite)
{
  Points2 points = sunflower(100);
  points.row(40) = points.row(3);
  points.row(41) = points.row(3);
  const TransportSites sites = distinctSites(points);
  EXPECT_EQ(sites.count(), 98);
  EXPECT_EQ(sites.SiteOfVertex[40], sites.SiteOfVertex[3]);
  EXPECT_EQ(sites.SiteOfVertex[41], sites.SiteOfVertex[3]);
}

// The interpolation of a known map from its values at the sites.
class FieldOf
{
public:
  template <typename Map>
  FieldOf(int count, const Map& map)
    : Points(sunflower(count))
    , Exact(Points.rows(), 2)
  {
    const Eigen::VectorXd masses = Eigen::VectorXd::Ones(this->Points.rows());
    const TransportSites sites =
      groupedSites(this->Points, masses, Eigen::VectorXd::Zero(this->Points.rows()), {}, 8);
    SiteImages images;
    images.Masses = sites.sums(masses);
    images.Positions.resize(sites.count(), 2);
    images.OnBoundary.assign(sites.count(), 0);
    for (int i = 0; i < sites.count(); ++i)
    {
      images.Positions.row(i) = map(Eigen::RowVector2d(sites.Positions.row(i)));
    }
    for (Eigen::Index v = 0; v < this->Points.rows(); ++v)
    {
      this->Exact.row(v) = map(Eigen::RowVector2d(this->Points.row(v)));
    }
    this->Field = interpolateTransport(sites, images, this->Points, UnitDisk());
  }

  // Away from the boundary, where stars are one-sided.
  double largestError() const
  {
    double largest = 0.0;
    for (Eigen::Index v = 0; v < this->Points.rows(); ++v)
    {
      if (this->Points.row(v).norm() < 0.8)
      {
        largest = std::max(largest, (this->Field.row(v) - this->Exact.row(v)).norm());
      }
    }
    return largest;
  }

  Points2 Points;
  Points2 Exact;
  Points2 Field;
};

TEST(TransportInterpolation, FollowsAnAffineMapExactly)
{
  const FieldOf field(3000,
    [](const Eigen::RowVector2d& p)
    { return Eigen::RowVector2d(0.1 + 0.5 * p.x() - 0.2 * p.y(), 0.3 * p.x() + 0.4 * p.y()); });
  EXPECT_LE((field.Field - field.Exact).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TransportInterpolation, FollowsASmoothMapToSecondOrder)
{
  const auto map = [](const Eigen::RowVector2d& p)
  {
    return Eigen::RowVector2d(
      0.5 * p.x() + 0.1 * std::sin(3.0 * p.y()), 0.5 * p.y() * (1.0 + 0.3 * p.x()));
  };
  const double coarse = FieldOf(2000, map).largestError();
  const double fine = FieldOf(32000, map).largestError();
  EXPECT_LE(coarse, 5e-3);
  EXPECT_LE(fine, coarse / 10.0); // 16 in the limit
}

TEST(TransportInterpolation, LeavesNoVertexOutsideOfTheDomain)
{
  const FieldOf field(3000, [](const Eigen::RowVector2d& p) { return Eigen::RowVector2d(1.3 * p); });
  EXPECT_LE(field.Field.rowwise().norm().maxCoeff(), 1.0 + 1e-15);
  EXPECT_GT(field.Exact.rowwise().norm().maxCoeff(), 1.2);
}

} // namespace
