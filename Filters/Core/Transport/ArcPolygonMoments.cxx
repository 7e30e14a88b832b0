// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/ArcPolygonMoments.h"

#include "Mesh/PlaneVectors.h"

#include <cmath>

namespace flattening
{
namespace
{

// Up to this angle the Taylor series is more accurate than the plain formula; at it the relative error
// of both is 3e-13.
constexpr double SmallAngle = 0.05;
// Negative angles down to this one are rounding errors of 0. A guard: with 0 an empty arc could become
// the whole circle.
constexpr double LeastAngle = -1e-9;

double angleMinusSine(double angle)
{
  if (angle > SmallAngle)
  {
    return angle - std::sin(angle);
  }
  const double square = angle * angle;
  return angle * square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0));
}

} // namespace

double arcAngle(const Eigen::Vector2d& p, const Eigen::Vector2d& q)
{
  const double angle = std::atan2(cross(p, q), p.dot(q));
  return angle >= 0.0 ? angle : angle > LeastAngle ? 0.0 : angle + 2.0 * EIGEN_PI;
}

void ArcPolygonMoments::addSide(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  const Eigen::Vector2d a = from - this->Origin;
  const Eigen::Vector2d b = to - this->Origin;
  const double area = 0.5 * cross(a, b);
  this->Area += area;
  this->Moment += area / 3.0 * (a + b);
}

// An arc is its chord and a circular segment.
void ArcPolygonMoments::addArc(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  const double angle = arcAngle(from, to);
  this->addSide(from, to);
  const double area = 0.5 * angleMinusSine(angle);
  if (area > 0.0)
  {
    const double middle = std::atan2(from.y(), from.x()) + 0.5 * angle;
    const double sine = std::sin(0.5 * angle);
    const double radius = 2.0 * sine * sine * sine / (3.0 * area);
    this->Area += area;
    this->Moment += area * (radius * Eigen::Vector2d(std::cos(middle), std::sin(middle)) - this->Origin);
  }
}

} // namespace flattening
