// SPDX-License-Identifier: GPL-3.0-or-later
/// The sites of a transport: vertices of a flat map, one by one or in groups.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Sites, and the site of every vertex.
struct TransportSites
{
  Points2 Positions;             ///< one row per site, pairwise distinct
  std::vector<int> SiteOfVertex; ///< per vertex (n)

  int count() const { return static_cast<int>(this->Positions.rows()); }
  /// Per site the sum of @p values (n) over its vertices.
  Eigen::VectorXd sums(const Eigen::VectorXd& values) const;
};

/// Every vertex is a site; vertices with equal positions share one.
TransportSites distinctSites(const Points2& positions);

/// Groups of at most @p verticesPerSite (>= 1) neighbouring vertices share one site, at their centre of
/// mass for @p masses (n, > 0). The vertices in @p alone are sites of their own, and so are those of a
/// group in which the scale of the map changes by more than a factor of e, unless the group is smaller
/// than 1e-12.
/// @param logScales  logarithm of flat over surface length at every vertex (n)
TransportSites groupedSites(const Points2& positions,
  const Eigen::VectorXd& masses,
  const Eigen::VectorXd& logScales,
  const std::vector<int>& alone,
  int verticesPerSite);

} // namespace flattening
