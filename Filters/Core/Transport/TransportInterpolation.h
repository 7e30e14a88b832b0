// SPDX-License-Identifier: GPL-3.0-or-later
/// A smooth map through the centroids of transported cells.
#pragma once

#include "Transport/BoundaryPlacement.h"
#include "Transport/PowerDiagram.h"
#include "Transport/TransportSites.h"

#include <vector>

namespace flattening
{

/// Where a transport takes its sites and the boundary vertices.
struct SiteImages
{
  Eigen::VectorXd Masses;                 ///< per site, > 0
  Points2 Positions;                      ///< per site
  std::vector<char> OnBoundary;           ///< per site: whether the map must take it exactly there
  std::vector<double> BoundaryParameters; ///< of the boundary vertices (boundaryParameters)
};

/// The images are the centroids of the cells of @p diagram, and on the boundary the points with the
/// boundaryParameters(). @p masses per site.
SiteImages siteImages(const PowerDiagram& diagram,
  const Eigen::VectorXd& masses,
  const TransportSites& sites,
  const BoundaryLoop& boundary);

/// Maps vertices at @p positions (n x 2) as the transport maps the sites around them. The optimal
/// transport is a smooth map, but the centroids of its cells follow it only to about the size of a cell,
/// and the order of the centroids of slivers is lost. Therefore an affine map is fitted at every site to
/// the images of the site and its neighbours (least squares, weighted by mass). Between the sites these
/// maps are blended by barycentric coordinates in the sites' Delaunay triangulation, which follows a
/// smooth map to second order. So faces keep their shapes up to the stretch of the map.
/// Vertices that would leave @p domain are put on its boundary.
Points2 interpolateTransport(const TransportSites& sites,
  const SiteImages& images,
  const Points2& positions,
  const ConvexDomain& domain);

} // namespace flattening
