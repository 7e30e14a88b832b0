// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/DomainPolygon.h"

#include "Base/Errors.h"
#include "Mesh/CoordinateFrame.h"
#include "Mesh/PlaneVectors.h"
#include "Transport/ConvexDomain.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <list>
#include <string>
#include <vector>

namespace flattening
{
namespace
{

// The least width of an outline over its length, and the distance of a point from the line through its
// neighbours, over the width, below which it is no corner. Guards: their product is above the rounding
// of coordinates, without which the corners of ConvexPolygon would not all be strictly convex, and
// points that are left out do not change the area.
constexpr double LeastWidth = 1e-6;
constexpr double OnTheLine = 1e-9;
// The least size of an outline, or of a map, over its largest coordinate. A guard: smaller ones have
// lost their shape to rounding.
constexpr double LeastSize = 1e-9;

void requireCoordinates(const Points2& outline, double size)
{
  for (Eigen::Index k = 0; k < outline.rows(); ++k)
  {
    if (!outline.row(k).allFinite())
    {
      throw InvalidInput("point " + std::to_string(k) +
                         " of the domain's outline is not finite: give the corners of a convex polygon");
    }
  }
  if (!(size > LeastSize * outline.cwiseAbs().maxCoeff()) || !std::isnormal(size))
  {
    throw InvalidInput("the domain's outline has an extent of " + formatted(size) +
                       ", too small or too large for its place: give a convex polygon near the origin");
  }
}

double areaOf(const Points2& outline)
{
  double area = 0.0;
  for (Eigen::Index k = 0; k + 1 < outline.rows(); ++k)
  {
    area += 0.5 * cross((outline.row(k) - outline.row(0)).transpose().eval(),
                    (outline.row(k + 1) - outline.row(0)).transpose().eval());
  }
  return area;
}

// The points without those that lie on the line through their neighbours, or nearer to it than a
// distance.
std::vector<Eigen::Vector2d> cornersOf(const Points2& outline, double distance)
{
  std::list<Eigen::Vector2d> corners; // of which any can be taken out in no time
  for (Eigen::Index k = 0; k < outline.rows(); ++k)
  {
    corners.emplace_back(outline.row(k));
  }
  using Corner = std::list<Eigen::Vector2d>::iterator;
  const auto isNone = [&](Corner corner)
  {
    const Corner next = std::next(corner);
    const Eigen::Vector2d before =
      *corner - *std::prev(corner == corners.begin() ? corners.end() : corner);
    const Eigen::Vector2d after = *(next == corners.end() ? corners.begin() : next) - *corner;
    return before.norm() <= distance ||
           (before.dot(after) > 0.0 &&
             std::abs(cross(before, after)) <= distance * (before + after).norm());
  };
  for (Corner corner = corners.begin(); corner != corners.end() && corners.size() > 1;)
  {
    if (isNone(corner))
    {
      corner = corners.erase(corner);
      corner = corner == corners.begin() ? corner : std::prev(corner);
    }
    else
    {
      ++corner;
    }
  }
  return { corners.begin(), corners.end() };
}

ConvexPolygon convexPolygon(const Points2& corners, const std::string& remedy)
{
  try
  {
    return ConvexPolygon(corners);
  }
  catch (const InvalidInput&)
  {
    throw InvalidInput("the domain's outline is not convex, or crosses itself" + remedy);
  }
}

} // namespace

DomainPolygon domainPolygon(const Points2& outline)
{
  const std::string remedy = ": give the corners of a convex polygon, three at least, in order";
  if (outline.rows() < 3)
  {
    throw InvalidInput(
      "the domain's outline has " + std::to_string(outline.rows()) + " points" + remedy);
  }
  requireCoordinates(outline, (outline.colwise().maxCoeff() - outline.colwise().minCoeff()).maxCoeff());
  const PlaneFrame frame(outline);
  const Points2 normalised = frame.normalised(outline);
  const double size = (normalised.colwise().maxCoeff() - normalised.colwise().minCoeff()).norm();
  const double area = areaOf(normalised);
  const double width = std::abs(area) / size;
  const std::vector<Eigen::Vector2d> corners = cornersOf(normalised, OnTheLine * width);
  if (corners.size() < 3 || !(width > LeastWidth * size))
  {
    throw InvalidInput(
      "the domain's outline has no area, or is more than a million times as long as wide" + remedy);
  }
  DomainPolygon polygon;
  polygon.Corners.resize(static_cast<Eigen::Index>(corners.size()), 2);
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    polygon.Corners.row(k) = corners[area > 0.0 ? k : corners.size() - 1 - k];
  }
  // Moved to the origin, where areas lose no digits.
  const Eigen::RowVector2d near = polygon.Corners.row(0);
  polygon.Corners.rowwise() -= near;
  const ConvexPolygon convex = convexPolygon(polygon.Corners, remedy);
  polygon.Corners.rowwise() -= convex.centroid().transpose();
  const double scale = std::sqrt(convex.area() / EIGEN_PI);
  polygon.Corners /= scale;
  polygon.Scale = frame.restoredLength(scale);
  polygon.Centroid = frame.restoredPoint(near.transpose() + convex.centroid());
  return polygon;
}

void requireResolved(const DomainPolygon& polygon, double radius)
{
  const double distance = polygon.Centroid.cwiseAbs().maxCoeff();
  if (!(radius > LeastSize * distance))
  {
    throw InvalidInput("the area of the surface is that of a disk of radius " + formatted(radius) +
                       ", but the domain's outline lies at a distance of " + formatted(distance) +
                       " from the origin, where double precision does not hold so small a map: scale "
                       "the outline to the area of the surface, or move its centre to the origin");
  }
}

} // namespace flattening
