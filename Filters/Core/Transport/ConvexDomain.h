// SPDX-License-Identifier: GPL-3.0-or-later
/// The region of the plane that a surface is flattened to.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Transport/ArcPolygonMoments.h"

#include <vector>

namespace flattening
{

/// Places on the boundary are numbers that grow counter-clockwise, modulo perimeter().
class ConvexDomain
{
public:
  virtual ~ConvexDomain() = default;

  virtual double area() const = 0;
  virtual bool isRound() const = 0; ///< whether its boundary is curved
  virtual Eigen::Vector2d centroid() const = 0;
  virtual double perimeter() const = 0;
  /// Of the largest disk around the origin that it contains; 0 if the origin lies outside.
  virtual double innerRadius() const = 0;
  virtual bool contains(const Eigen::Vector2d& point) const = 0; ///< its boundary belongs to it

  /// The point at a place on the boundary.
  virtual Eigen::Vector2d at(double place) const = 0;
  /// Its derivative by the place, of length 1; in a corner that of the side which begins there.
  virtual Eigen::Vector2d tangentAt(double place) const = 0;
  /// The place where the ray from the centroid through @p point meets the boundary.
  virtual double placeOf(const Eigen::Vector2d& point) const = 0;

  /// What a line has in common with the domain, from where it enters to where it leaves.
  struct Chord
  {
    Eigen::Vector2d Enter;
    Eigen::Vector2d Leave;
    double EnterAt; ///< in units of the direction, from the given point
    double LeaveAt;
  };
  /// @p direction of length 1. False if the line misses the domain.
  virtual bool cross(const Eigen::Vector2d& point,
    const Eigen::Vector2d& direction,
    Chord& chord) const = 0;

  /// Counter-clockwise along the boundary between two points on it, in places; 0 for what rounding
  /// turned around, never the whole perimeter.
  virtual double distanceAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const = 0;
  /// Adds this part of the boundary to the measure of a region.
  virtual void addBoundary(const Eigen::Vector2d& from,
    const Eigen::Vector2d& to,
    ArcPolygonMoments& region) const = 0;
  /// Points strictly between the two, so that the polyline through them follows the boundary: a curved
  /// part in steps of at most @p maximumStep radians.
  virtual std::vector<Eigen::Vector2d> pointsBetween(const Eigen::Vector2d& from,
    const Eigen::Vector2d& to,
    double maximumStep) const = 0;
  /// The same all around, from place 0.
  virtual std::vector<Eigen::Vector2d> outline(double maximumStep) const = 0;
};

/// The disk of radius 1 around the origin; places are angles.
class UnitDisk : public ConvexDomain
{
public:
  double area() const override { return EIGEN_PI; }
  bool isRound() const override { return true; }
  Eigen::Vector2d centroid() const override { return Eigen::Vector2d::Zero(); }
  double perimeter() const override { return 2.0 * EIGEN_PI; }
  double innerRadius() const override { return 1.0; }
  bool contains(const Eigen::Vector2d& point) const override { return point.squaredNorm() <= 1.0; }
  Eigen::Vector2d at(double place) const override;
  Eigen::Vector2d tangentAt(double place) const override;
  double placeOf(const Eigen::Vector2d& point) const override;
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

/// A polygon; places are lengths along it from its first corner.
class ConvexPolygon : public ConvexDomain
{
public:
  /// @p corners k x 2, counter-clockwise, k >= 3.
  /// @throws InvalidInput if they are not the corners of a strictly convex polygon in that order.
  explicit ConvexPolygon(const Points2& corners);

  std::vector<double> cornerPlaces() const; ///< in order, from 0

  double area() const override { return this->Area; }
  bool isRound() const override { return false; }
  Eigen::Vector2d centroid() const override { return this->Centroid; }
  double perimeter() const override { return this->Along.back(); }
  double innerRadius() const override;
  bool contains(const Eigen::Vector2d& point) const override;
  Eigen::Vector2d at(double place) const override;
  Eigen::Vector2d tangentAt(double place) const override;
  double placeOf(const Eigen::Vector2d& point) const override;
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
  int sideAt(double& place) const; ///< takes whole turns off the place

  Points2 Corners;
  Points2 Inwards;           // normals of the sides
  std::vector<double> Along; // places of the corners, and the perimeter
  double Area = 0.0;
  Eigen::Vector2d Centroid;
};

} // namespace flattening
