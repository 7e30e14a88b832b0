// SPDX-License-Identifier: GPL-3.0-or-later
/// The region of the plane that a surface is flattened to.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Transport/ArcPolygonMoments.h"

#include <vector>

namespace flattening
{

/// A convex region with its boundary. A boundary parameter is a number that names a point of the
/// boundary; it grows counter-clockwise at unit speed, modulo perimeter().
class ConvexDomain
{
public:
  virtual ~ConvexDomain() = default;

  virtual double area() const = 0;
  virtual bool isRound() const = 0; ///< whether its boundary is curved
  virtual Eigen::Vector2d centroid() const = 0;
  virtual double perimeter() const = 0;
  /// Radius of the largest disk around the origin in the domain; 0 if the origin lies outside.
  virtual double innerRadius() const = 0;
  virtual bool contains(const Eigen::Vector2d& point) const = 0; ///< true on the boundary

  /// The point of the boundary with @p parameter.
  virtual Eigen::Vector2d at(double parameter) const = 0;
  /// The derivative of at(), of length 1; in a corner that of the side which begins there.
  virtual Eigen::Vector2d tangentAt(double parameter) const = 0;
  /// The parameter of the point where the ray from the centroid through @p point meets the boundary.
  virtual double parameterOf(const Eigen::Vector2d& point) const = 0;

  /// @p parameter shifted by whole turns to lie in [@p first, @p first + perimeter()).
  double parameterAfter(double first, double parameter) const;
  /// The parameters of rows @p loop of @p positions, shifted by whole turns to lie less than one turn
  /// after the first.
  Eigen::VectorXd parametersOf(const Points2& positions, const std::vector<int>& loop) const;
  /// Whether @p parameters increase strictly over less than one turn.
  bool areInOrder(const Eigen::VectorXd& parameters) const;

  /// The part of a line inside the domain.
  struct Chord
  {
    Eigen::Vector2d Enter;
    Eigen::Vector2d Leave;
    double EnterAt; ///< distance of Enter from the given point along the direction, signed
    double LeaveAt; ///< the same for Leave
  };
  /// Cuts the line through @p point along @p direction (of length 1) to the domain; returns false if the
  /// line misses the domain.
  virtual bool cross(const Eigen::Vector2d& point,
    const Eigen::Vector2d& direction,
    Chord& chord) const = 0;

  /// The length of the boundary counter-clockwise from one of its points to another; 0 if rounding
  /// exchanged two nearly equal points, never the whole perimeter.
  virtual double distanceAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const = 0;
  /// Adds this part of the boundary to the moments of a region.
  virtual void addBoundary(const Eigen::Vector2d& from,
    const Eigen::Vector2d& to,
    ArcPolygonMoments& region) const = 0;
  /// Points of the boundary strictly between the two, for a polyline that follows the boundary: corners,
  /// or steps of at most @p maximumStep radians on a circle.
  virtual std::vector<Eigen::Vector2d> pointsBetween(const Eigen::Vector2d& from,
    const Eigen::Vector2d& to,
    double maximumStep) const = 0;
  /// The same for the whole boundary, from parameter 0 on.
  virtual std::vector<Eigen::Vector2d> outline(double maximumStep) const = 0;
};

/// The disk of radius 1 around the origin; boundary parameters are angles.
class UnitDisk : public ConvexDomain
{
public:
  double area() const override { return EIGEN_PI; }
  bool isRound() const override { return true; }
  Eigen::Vector2d centroid() const override { return Eigen::Vector2d::Zero(); }
  double perimeter() const override { return 2.0 * EIGEN_PI; }
  double innerRadius() const override { return 1.0; }
  bool contains(const Eigen::Vector2d& point) const override { return point.squaredNorm() <= 1.0; }
  Eigen::Vector2d at(double parameter) const override;
  Eigen::Vector2d tangentAt(double parameter) const override;
  double parameterOf(const Eigen::Vector2d& point) const override;
  bool cross(const Eigen::Vector2d& point,
    const Eigen::Vector2d& direction,
    Chord& chord) const override;
  double distanceAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const override;
  void addBoundary(const Eigen::Vector2d& from,
    const Eigen::Vector2d& to,
    ArcPolygonMoments& region) const override;
  std::vector<Eigen::Vector2d> pointsBetween(const Eigen::Vector2d& from,
    const Eigen::Vector2d& to,
    double maximumStep) const override;
  std::vector<Eigen::Vector2d> outline(double maximumStep) const override;
};

/// A convex polygon; boundary parameters are lengths along it from its first corner.
class ConvexPolygon : public ConvexDomain
{
public:
  /// @p corners k x 2, counter-clockwise, k >= 3.
  /// @throws InvalidInput if they are not the corners of a strictly convex polygon in that order.
  explicit ConvexPolygon(const Points2& corners);

  std::vector<double> cornerParameters() const; ///< in order, from 0

  double area() const override { return this->Area; }
  bool isRound() const override { return false; }
  Eigen::Vector2d centroid() const override { return this->Centroid; }
  double perimeter() const override { return this->Along.back(); }
  double innerRadius() const override;
  bool contains(const Eigen::Vector2d& point) const override;
  Eigen::Vector2d at(double parameter) const override;
  Eigen::Vector2d tangentAt(double parameter) const override;
  double parameterOf(const Eigen::Vector2d& point) const override;
  bool cross(const Eigen::Vector2d& point,
    const Eigen::Vector2d& direction,
    Chord& chord) const override;
  double distanceAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const override;
  void addBoundary(const Eigen::Vector2d& from,
    const Eigen::Vector2d& to,
    ArcPolygonMoments& region) const override;
  std::vector<Eigen::Vector2d> pointsBetween(const Eigen::Vector2d& from,
    const Eigen::Vector2d& to,
    double maximumStep) const override;
  std::vector<Eigen::Vector2d> outline(double maximumStep) const override;

private:
  int count() const { return static_cast<int>(this->Corners.rows()); }
  Eigen::Vector2d corner(int k) const { return this->Corners.row(k % this->count()); }
  double height(int side, const Eigen::Vector2d& point) const;
  int sideAt(double& parameter) const; // takes whole turns off the parameter

  Points2 Corners;
  Points2 Inwards;           // normals of the sides
  std::vector<double> Along; // parameters of the corners, and the perimeter
  double Area = 0.0;
  Eigen::Vector2d Centroid;
};

} // namespace flattening
