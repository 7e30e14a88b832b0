// SPDX-License-Identifier: GPL-3.0-or-later
/// A start near the result: the map that was found for other weights.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Transport/ConvexDomain.h"
#include "Transport/TransportInterpolation.h"
#include "Transport/TransportSites.h"

#include <vector>

namespace flattening
{

/// Where a transport puts its sites, and the vertices of the boundary loop.
struct TransportedSites
{
  SiteImages Images;
  std::vector<double> Places; ///< of the boundary (ConvexDomain.h), in order, modulo the perimeter
};

/// Whether @p positions (n x 2) is a map to @p domain from which refinement may go on: no face flipped,
/// the boundary loop on the boundary of the domain and in order, its members @p corners where
/// @p cornerPlaces are.
bool isRefinedMap(const Points2& positions,
  const FaceMatrix& faces,
  const ConvexDomain& domain,
  const std::vector<int>& loop,
  const std::vector<int>& corners,
  const std::vector<double>& cornerPlaces);

/// A refined map @p positions of the transport @p before, carried on to the transport @p after: between
/// the two, which differ little, sites move by a smooth field (interpolateTransport), and what
/// refinement had corrected within a site stays corrected. Boundary vertices move as the places of the
/// transports, linearly in between.
Points2 carriedMap(const Points2& positions,
  const TransportSites& sites,
  const TransportedSites& before,
  const TransportedSites& after,
  const std::vector<int>& loop,
  const ConvexDomain& domain);

} // namespace flattening
