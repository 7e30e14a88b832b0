// SPDX-License-Identifier: GPL-3.0-or-later
/// A convex polygon as the domain of a flat map, from an outline of any size anywhere in the plane.
#pragma once

#include "Mesh/TriangleMesh.h"

namespace flattening
{

struct DomainPolygon
{
  Points2 Corners;          ///< k x 2, counter-clockwise, with area pi and the centroid at 0
  double Scale = 1.0;       ///< of the outline over that
  Eigen::Vector2d Centroid; ///< of the outline
};

/// Of the polygon with corners @p outline (k x 2) in either direction. Points that repeat the one before
/// or lie on the line from it to the next, to 1e-9 of their distances, are no corners and are left out.
/// @throws InvalidInput if one is not finite, or if the rest is not a convex polygon of three corners at
/// least, of a size that doubles resolve at its place.
DomainPolygon domainPolygon(const Points2& outline);

} // namespace flattening
