// SPDX-License-Identifier: GPL-3.0-or-later
/// A convex polygon as the domain of a flat map, from an outline of any size anywhere in the plane.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// The polygon at a standard size and place, and how to return to the outline's.
struct DomainPolygon
{
  Points2 Corners;          ///< k x 2, counter-clockwise, with area pi and the centroid at 0
  double Scale = 1.0;       ///< length in the outline over length in Corners
  Eigen::Vector2d Centroid; ///< centroid of the outline
};

/// Standardises the polygon with corners @p outline (k x 2), in either direction. Points that repeat the
/// previous point or lie on the line from it to the next, up to 1e-9 of their distances, are no corners
/// and are left out.
/// @throws InvalidInput if a point is not finite, if the others do not form a convex polygon with at
/// least three corners, or if the polygon is too small for double precision at its distance from the
/// origin.
DomainPolygon domainPolygon(const Points2& outline);

/// Checks that a map with the area of a disk of radius @p radius, in the units of the outline, keeps its
/// shape around the centroid of @p polygon.
/// @throws InvalidInput if the radius is at most 1e-9 of the distance from there to the origin.
void requireResolved(const DomainPolygon& polygon, double radius);

} // namespace flattening
