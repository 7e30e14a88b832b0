// SPDX-License-Identifier: GPL-3.0-or-later
/// Coordinates in which the size and the place of a surface do not matter.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// The change of coordinates x -> 2^-k (x - o), after which products of coordinates neither overflow nor
/// underflow, and no digits are lost in the distance from the origin. It is exact, and so is its
/// inverse, for the points that it was made for: k is a whole number, and the difference of two numbers
/// of one sign of which neither is more than twice the other is exact (Sterbenz 1974, "Floating-point
/// computation"). It is the identity for surfaces of between 2^-32 and 2^32 units that are no farther
/// from the origin than a thousand times their size, so that their results and messages keep the units
/// of the input.
class CoordinateFrame
{
public:
  /// The identity.
  CoordinateFrame() = default;

  /// The frame of the vertices of faces. Vertices that are not finite are not counted.
  /// @throws InvalidInput if the surface is larger or smaller than double precision holds, or so far
  /// from the origin that double precision cannot hold points between its vertices.
  explicit CoordinateFrame(const TriangleMesh& mesh);

  bool isIdentity() const { return !this->changesSize() && this->Origin.isZero(0.0); }
  bool changesSize() const { return this->Exponent != 0; }

  TriangleMesh normalised(const TriangleMesh& mesh) const;
  Eigen::Vector3d normalisedPoint(const Eigen::Vector3d& point) const;
  double normalisedLength(double length) const;

  Points3 restored(const Points3& points) const;
  Eigen::Vector3d restoredPoint(const Eigen::Vector3d& point) const;
  double restoredLength(double length) const;
  /// Infinite or 0 if double precision does not hold the area in the units of the input.
  double restoredArea(double area) const;

private:
  int Exponent = 0;
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero();
};

/// The same for positions in the plane, which are scaled only: x -> 2^-k x.
class PlaneFrame
{
public:
  explicit PlaneFrame(const Points2& positions);

  Points2 normalised(const Points2& positions) const;
  Eigen::Vector2d restoredPoint(const Eigen::Vector2d& point) const;
  double restoredLength(double length) const;
  /// Infinite or 0 if double precision does not hold the area in the units of the map.
  double restoredArea(double area) const;

private:
  int Exponent = 0;
};

} // namespace flattening
