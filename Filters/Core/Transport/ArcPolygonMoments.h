// SPDX-License-Identifier: GPL-3.0-or-later
/// The area and centroid of a region bounded by straight sides and arcs of the unit circle.
#pragma once

#include <Eigen/Core>

namespace flattening
{

/// The counter-clockwise angle from @p p to @p q, both on the unit circle, in [0, 2 pi); 0 if rounding
/// exchanged two nearly equal points, never the whole circle.
double arcAngle(const Eigen::Vector2d& p, const Eigen::Vector2d& q);

/// Sums over the pieces of a region's closed boundary, counter-clockwise; exact up to rounding.
class ArcPolygonMoments
{
public:
  /// Sums are relative to @p origin, which should be a point of the region, or digits cancel.
  explicit ArcPolygonMoments(const Eigen::Vector2d& origin)
    : Origin(origin)
  {
  }
  void addSide(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  void addArc(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

  double area() const { return this->Area; }
  /// Undefined if the area is 0.
  Eigen::Vector2d centroid() const { return this->Origin + this->Moment / this->Area; }

private:
  Eigen::Vector2d Origin;
  double Area = 0.0;
  Eigen::Vector2d Moment = Eigen::Vector2d::Zero();
};

} // namespace flattening
