// SPDX-License-Identifier: GPL-3.0-or-later
/// Area and centroid of a region whose boundary is straight sides and arcs of the unit circle.
#pragma once

#include <Eigen/Core>

namespace flattening
{

/// z component of the cross product.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Counter-clockwise angle from @p p to @p q, both on the unit circle, in [0, 2 pi). An arc that
/// rounding turned around is an empty one, not the whole circle.
double arcAngle(const Eigen::Vector2d& p, const Eigen::Vector2d& q);

/// Sums up the pieces of a region's boundary, counter-clockwise and closed, exactly but for rounding.
class ArcPolygonMoments
{
public:
  /// All is summed relative to @p origin: a point of the region, or digits cancel.
  explicit ArcPolygonMoments(const Eigen::Vector2d& origin)
    : Origin(origin)
  {
  }
  void addSide(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  void addArc(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

  double area() const { return this->Area; }
  /// Meaningless if the area is 0.
  Eigen::Vector2d centroid() const { return this->Origin + this->Moment / this->Area; }

private:
  Eigen::Vector2d Origin;
  double Area = 0.0;
  Eigen::Vector2d Moment = Eigen::Vector2d::Zero();
};

} // namespace flattening
