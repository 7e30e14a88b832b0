// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/ConvexDomain.h"

#include "Base/Errors.h"
#include "Mesh/PlaneVectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace flattening
{
namespace
{

// A length along the boundary within this share of the whole perimeter is that between two nearly equal
// points in exchanged order. A guard far above rounding (1e-16) and far below a boundary edge; with 0 a
// cell could get the whole boundary.
constexpr double ExchangedShare = 1e-9;

} // namespace

double ConvexDomain::parameterAfter(double first, double parameter) const
{
  const double along = parameter - first;
  return first + along - this->perimeter() * std::floor(along / this->perimeter());
}

Eigen::VectorXd ConvexDomain::parametersOf(const Points2& positions, const std::vector<int>& loop) const
{
  Eigen::VectorXd parameters(static_cast<Eigen::Index>(loop.size()));
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const double parameter = this->parameterOf(positions.row(loop[k]).transpose());
    parameters[k] = k == 0 ? parameter : this->parameterAfter(parameters[0], parameter);
  }
  return parameters;
}

bool ConvexDomain::areInOrder(const Eigen::VectorXd& parameters) const
{
  const Eigen::Index steps = parameters.size() - 1;
  return (parameters.head(steps).array() < parameters.tail(steps).array()).all() &&
         parameters[steps] - parameters[0] < this->perimeter();
}

Eigen::Vector2d UnitDisk::at(double parameter) const
{
  return { std::cos(parameter), std::sin(parameter) };
}

Eigen::Vector2d UnitDisk::tangentAt(double parameter) const
{
  return { -std::sin(parameter), std::cos(parameter) };
}

double UnitDisk::parameterOf(const Eigen::Vector2d& point) const
{
  return std::atan2(point.y(), point.x());
}

bool UnitDisk::cross(const Eigen::Vector2d& point, const Eigen::Vector2d& direction, Chord& chord) const
{
  const Eigen::Vector2d normal(direction.y(), -direction.x());
  const double distance = point.dot(normal); // of the line from the centre
  if (!(std::abs(distance) < 1.0))
  {
    return false;
  }
  const double half = std::sqrt((1.0 - distance) * (1.0 + distance));
  const double foot = point.dot(direction);
  chord = { distance * normal - half * direction,
    distance * normal + half * direction,
    -foot - half,
    -foot + half };
  return true;
}

double UnitDisk::distanceAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
{
  return arcAngle(from, to);
}

void UnitDisk::addBoundary(const Eigen::Vector2d& from,
  const Eigen::Vector2d& to,
  ArcPolygonMoments& region) const
{
  region.addArc(from, to);
}

std::vector<Eigen::Vector2d> UnitDisk::pointsBetween(const Eigen::Vector2d& from,
  const Eigen::Vector2d& to,
  double maximumStep) const
{
  const double length = arcAngle(from, to);
  const double start = this->parameterOf(from);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / maximumStep)));
  std::vector<Eigen::Vector2d> points;
  for (int k = 1; k < steps; ++k)
  {
    points.push_back(this->at(start + length * k / steps));
  }
  return points;
}

std::vector<Eigen::Vector2d> UnitDisk::outline(double maximumStep) const
{
  const int steps = std::max(3, static_cast<int>(std::ceil(2.0 * EIGEN_PI / maximumStep)));
  std::vector<Eigen::Vector2d> points;
  for (int k = 0; k < steps; ++k)
  {
    points.push_back(this->at(2.0 * EIGEN_PI * k / steps));
  }
  return points;
}

ConvexPolygon::ConvexPolygon(const Points2& corners)
  : Corners(corners)
  , Inwards(corners.rows(), 2)
  , Along{ 0.0 }
{
  if (this->count() < 3 || !corners.allFinite())
  {
    throw InvalidInput("a domain of " + std::to_string(this->count()) +
                       " corners: give the finite corners of a convex polygon, three at least");
  }
  ArcPolygonMoments region(this->corner(0));
  double turns = 0.0;
  for (int k = 0; k < this->count(); ++k)
  {
    const Eigen::Vector2d side = this->corner(k + 1) - this->corner(k);
    const Eigen::Vector2d following = this->corner(k + 2) - this->corner(k + 1);
    const double turn = std::atan2(flattening::cross(side, following), side.dot(following));
    if (!(turn > 0.0))
    {
      throw InvalidInput("the domain's corner " + std::to_string((k + 1) % this->count()) +
                         " does not turn to the left: give the corners of a convex polygon "
                         "counter-clockwise, without corners of 180 degrees");
    }
    turns += turn;
    const double length = side.norm();
    this->Inwards.row(k) << -side.y() / length, side.x() / length;
    this->Along.push_back(this->Along.back() + length);
    region.addSide(this->corner(k), this->corner(k + 1));
  }
  if (turns > 2.5 * EIGEN_PI)
  {
    throw InvalidInput(
      "the domain's corners turn around more than once: give those of a convex polygon");
  }
  this->Area = region.area();
  this->Centroid = region.centroid();
}

std::vector<double> ConvexPolygon::cornerParameters() const
{
  return { this->Along.begin(), this->Along.end() - 1 };
}

double ConvexPolygon::height(int side, const Eigen::Vector2d& point) const
{
  return this->Inwards.row(side).dot((point - this->corner(side)).transpose());
}

double ConvexPolygon::innerRadius() const
{
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < this->count(); ++k)
  {
    least = std::min(least, this->height(k, Eigen::Vector2d::Zero()));
  }
  return std::max(0.0, least);
}

bool ConvexPolygon::contains(const Eigen::Vector2d& point) const
{
  for (int k = 0; k < this->count(); ++k)
  {
    if (!(this->height(k, point) >= 0.0))
    {
      return false;
    }
  }
  return true;
}

int ConvexPolygon::sideAt(double& parameter) const
{
  parameter -= this->perimeter() * std::floor(parameter / this->perimeter());
  const auto after = std::upper_bound(this->Along.begin() + 1, this->Along.end() - 1, parameter);
  return static_cast<int>(after - this->Along.begin()) - 1;
}

Eigen::Vector2d ConvexPolygon::tangentAt(double parameter) const
{
  const int k = this->sideAt(parameter);
  return (this->corner(k + 1) - this->corner(k)) / (this->Along[k + 1] - this->Along[k]);
}

Eigen::Vector2d ConvexPolygon::at(double parameter) const
{
  const int k = this->sideAt(parameter);
  const double t = (parameter - this->Along[k]) / (this->Along[k + 1] - this->Along[k]);
  return this->corner(k) + t * (this->corner(k + 1) - this->corner(k)); // exact along the axes
}

double ConvexPolygon::parameterOf(const Eigen::Vector2d& point) const
{
  // The ray meets the side above which the point is lowest, relative to the centroid's height.
  int side = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < this->count(); ++k)
  {
    const double share = this->height(k, point) / this->height(k, this->Centroid);
    if (share < least)
    {
      least = share;
      side = k;
    }
  }
  if (!(least < 1.0))
  {
    return 0.0; // the point is the centroid: every direction is right
  }
  const Eigen::Vector2d there = this->Centroid + (point - this->Centroid) / (1.0 - least);
  const Eigen::Vector2d along = this->corner(side + 1) - this->corner(side);
  const double t = std::clamp((there - this->corner(side)).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return this->Along[side] + t * (this->Along[side + 1] - this->Along[side]);
}

bool ConvexPolygon::cross(const Eigen::Vector2d& point,
  const Eigen::Vector2d& direction,
  Chord& chord) const
{
  chord.EnterAt = -std::numeric_limits<double>::infinity();
  chord.LeaveAt = std::numeric_limits<double>::infinity();
  int enter = -1;
  int leave = -1;
  for (int k = 0; k < this->count(); ++k)
  {
    const double height = this->height(k, point);
    const double climb = this->Inwards.row(k).dot(direction.transpose());
    if (climb == 0.0)
    {
      if (!(height > 0.0))
      {
        return false;
      }
      continue;
    }
    const double at = -height / climb;
    if (climb > 0.0 && at > chord.EnterAt)
    {
      chord.EnterAt = at;
      enter = k;
    }
    if (climb < 0.0 && at < chord.LeaveAt)
    {
      chord.LeaveAt = at;
      leave = k;
    }
  }
  if (enter < 0 || leave < 0 || !(chord.EnterAt < chord.LeaveAt))
  {
    return false;
  }
  // Projects onto the side, so that the point lies on it up to rounding.
  const auto onSide = [&](int side, double at) -> Eigen::Vector2d
  {
    const Eigen::Vector2d along = this->corner(side + 1) - this->corner(side);
    const double t = (point + at * direction - this->corner(side)).dot(along) / along.squaredNorm();
    return this->corner(side) + std::clamp(t, 0.0, 1.0) * along;
  };
  chord.Enter = onSide(enter, chord.EnterAt);
  chord.Leave = onSide(leave, chord.LeaveAt);
  return true;
}

double ConvexPolygon::distanceAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
{
  const double distance = this->parameterOf(to) - this->parameterOf(from);
  const double ahead = distance < 0.0 ? distance + this->perimeter() : distance;
  return ahead > (1.0 - ExchangedShare) * this->perimeter() ? 0.0 : ahead;
}

std::vector<Eigen::Vector2d> ConvexPolygon::pointsBetween(const Eigen::Vector2d& from,
  const Eigen::Vector2d& to,
  double) const
{
  const double start = this->parameterOf(from);
  const double end = start + this->distanceAlong(from, to);
  std::vector<Eigen::Vector2d> points;
  for (int k = 0; k < 2 * this->count(); ++k)
  {
    const double parameter =
      this->Along[k % this->count()] + (k < this->count() ? 0.0 : this->perimeter());
    if (parameter > start && parameter < end)
    {
      points.push_back(this->corner(k));
    }
  }
  return points;
}

void ConvexPolygon::addBoundary(const Eigen::Vector2d& from,
  const Eigen::Vector2d& to,
  ArcPolygonMoments& region) const
{
  Eigen::Vector2d last = from;
  for (const Eigen::Vector2d& corner : this->pointsBetween(from, to, 0.0))
  {
    region.addSide(last, corner);
    last = corner;
  }
  region.addSide(last, to);
}

std::vector<Eigen::Vector2d> ConvexPolygon::outline(double) const
{
  std::vector<Eigen::Vector2d> points;
  for (int k = 0; k < this->count(); ++k)
  {
    points.push_back(this->corner(k));
  }
  return points;
}

} // namespace flattening
