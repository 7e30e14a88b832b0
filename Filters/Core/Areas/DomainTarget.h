// SPDX-License-Identifier: GPL-3.0-or-later
/// The target of an area-preserving map: a convex domain, and the vertices on its boundary.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Transport/BoundaryPlacement.h"
#include "Transport/ConvexDomain.h"

#include <memory>

namespace flattening
{

/// A domain of area pi, and the boundary vertices that go to its boundary. Corners of the boundary may
/// be empty where CornerParameters are not: the vertices that stay in the corners are then found by
/// their power cells.
struct DomainTarget
{
  std::shared_ptr<const ConvexDomain> Domain;
  BoundaryLoop Boundary;
};

/// A convex polygon that a surface is mapped to.
struct PolygonTarget
{
  Points2 Corners; ///< k x 2, counter-clockwise, with area pi and its centroid at 0 (DomainPolygon.h)
  /// Whether a boundary vertex stays in each corner: the one whose power cell contains the corner.
  /// Otherwise the boundary edges across the corners cut these off.
  bool FixCorners = false;
};

/// The unit disk, for the map @p conformal (n x 2) to it.
/// @throws InvalidInput if @p conformal is no such map, TopologyError if @p mesh is no disk.
DomainTarget diskTarget(const TriangleMesh& mesh, const Points2& conformal);

/// The rectangle of area pi around the origin with the extent @p width along x, for the map @p conformal
/// to it, which has a boundary vertex in each of its corners. @throws as diskTarget, and InvalidInput if
/// @p width is not positive.
DomainTarget rectangleTarget(const TriangleMesh& mesh, const Points2& conformal, double width);

/// The polygon @p polygon, for a map @p conformal to another domain @p source. @throws as diskTarget.
DomainTarget polygonTarget(const TriangleMesh& mesh,
  const Points2& conformal,
  const ConvexDomain& source,
  const PolygonTarget& polygon);

/// @p positions (n x 2) in the domain @p from with every ray from the centroid, which is 0 in both
/// domains, stretched to its length in the domain @p to.
Points2 stretchedAlongRays(const Points2& positions, const ConvexDomain& from, const ConvexDomain& to);

} // namespace flattening
