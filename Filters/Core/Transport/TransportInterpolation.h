// SPDX-License-Identifier: GPL-3.0-or-later
/// A smooth map through the centroids of transported cells.
#pragma once

#include "Transport/PowerDiagram.h"
#include "Transport/TransportSites.h"

#include <vector>

namespace flattening
{

/// Where the sites of a transport are taken to.
struct SiteImages
{
  Eigen::VectorXd Masses;       ///< per site, > 0
  Points2 Positions;            ///< per site
  std::vector<char> OnBoundary; ///< per site: whether its image holds exactly
};

/// The centroids of the cells of @p diagram, and the places on the domain's boundary (ConvexDomain.h)
/// for the vertices of the boundary loop. @p masses per site.
SiteImages siteImages(const PowerDiagram& diagram,
  const Eigen::VectorXd& masses,
  const TransportSites& sites,
  const std::vector<int>& loop,
  const std::vector<double>& places);

/// The optimal transport is a smooth map, but the centroids of its cells follow it only to about the
/// size of a cell, and their order in slivers is lost. At every site the affine map is taken that fits
/// best, in the sense of least squares by mass, how its neighbours and itself are moved; between the
/// sites these maps are blended by barycentric coordinates in the sites' Delaunay triangulation, which
/// follows a smooth map to second order. So faces keep, but for the stretch, the shapes that they have
/// at @p positions (n x 2), and vertices that are no sites are moved as those around them.
/// Vertices that would leave @p domain are put on its boundary.
Points2 interpolateTransport(const TransportSites& sites,
  const SiteImages& images,
  const Points2& positions,
  const ConvexDomain& domain);

} // namespace flattening
