// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/DomainPolygon.h"

#include "Base/Errors.h"
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

// A point is no corner if the sine of the angle there is smaller, and an outline has no area if its area
// over its squared size is. A guard, chosen far above the rounding of coordinates; with 0 the corners of
// ConvexPolygon would not all be strictly convex.
constexpr double OnTheLine = 1e-9;
// The least size of an outline over its largest coordinate. A guard: smaller ones have lost their shape
// to rounding.
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

// The points without those at which the outline goes straight on.
std::vector<Eigen::Vector2d> cornersOf(const Points2& outline, double size)
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
    return before.norm() <= OnTheLine * size ||
           (before.dot(after) > 0.0 &&
             std::abs(cross(before, after)) <= OnTheLine * before.norm() * after.norm());
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
  // Scaled by a power of two, so that products of three coordinates neither overflow nor underflow.
  int exponent = 0;
  std::frexp(outline.cwiseAbs().maxCoeff(), &exponent);
  const Points2 unit = outline.unaryExpr([exponent](double x) { return std::ldexp(x, -exponent); });
  const double size = (unit.colwise().maxCoeff() - unit.colwise().minCoeff()).norm();
  const std::vector<Eigen::Vector2d> corners = cornersOf(unit, size);
  double area = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    area += 0.5 * cross(corners[k] - corners[0], corners[(k + 1) % corners.size()] - corners[0]);
  }
  if (corners.size() < 3 || !(std::abs(area) > OnTheLine * size * size))
  {
    throw InvalidInput("the domain's outline has no area" + remedy);
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
  polygon.Scale = std::ldexp(scale, exponent);
  polygon.Centroid = (near.transpose() + convex.centroid())
                       .unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
  return polygon;
}

} // namespace flattening
