// SPDX-License-Identifier: GPL-3.0-or-later
/// Warm starts: the result for other area weights as the start for the next.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Transport/PowerDiagram.h"
#include "Transport/TransportInterpolation.h"
#include "Transport/TransportSites.h"

#include <optional>
#include <vector>

namespace flattening
{

/// A result for the same surface and domain with other area weights. Arrays of other sizes are ignored:
/// the map is then the one that is found without a warm start, in every bit.
struct WarmStart
{
  /// AreaPreservingMap::PowerWeights of that result (n), or empty. They are taken if no cell is off by
  /// more than a decade, or if they are nearer to the targets than the usual starts.
  Eigen::VectorXd PowerWeights;
  /// AreaPreservingMap::Positions of that result (n x 2), refined, or empty. Refinement goes on from
  /// there, which takes a quarter to two fifths of the time where area weights have changed little.
  Points2 Positions;

  /// The power weights of the sites; empty if there are none for these vertices.
  Eigen::VectorXd weightsOf(const TransportSites& sites) const;
};

/// Where the refinement of a map begins.
enum class RefinementStart
{
  Transport, ///< the interpolated transport: many faces are off
  WarmStart  ///< a map that was refined for other weights: a few faces are off, and by little
};

/// Whether the vertices of @p loop lie on the boundary of @p domain at @p positions (n x 2), up to the
/// rounding of a change of units.
bool areOnBoundary(const Points2& positions, const std::vector<int>& loop, const ConvexDomain& domain);

/// The positions of @p start carried to the transport @p diagram (see carriedMap). Nothing if they are
/// no one-to-one map of @p faces to the domain with the boundary vertices and corners where they belong,
/// or if carrying them flips more than 1 % of the faces.
/// @param images  the siteImages() of @p diagram
std::optional<Points2> warmPositions(const WarmStart& start,
  const FaceMatrix& faces,
  const TransportSites& sites,
  const PowerDiagram& diagram,
  const SiteImages& images,
  const BoundaryLoop& boundary);

/// A refined map @p positions (n x 2) of the transport @p before, carried to the transport @p after. The
/// sites of the two differ by a smooth field (interpolateTransport), which moves the vertices and leaves
/// corrected what refinement had corrected within a site. Boundary vertices (@p loop) move with the
/// boundary parameters of the transports, linearly in between.
Points2 carriedMap(const Points2& positions,
  const TransportSites& sites,
  const SiteImages& before,
  const SiteImages& after,
  const std::vector<int>& loop,
  const ConvexDomain& domain);

} // namespace flattening
