// SPDX-License-Identifier: GPL-3.0-or-later
/// The sites of a transport: vertices of a flat map, one by one or in groups.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

struct TransportSites
{
  Points2 Positions;             ///< pairwise distinct
  std::vector<int> SiteOfVertex; ///< n

  int count() const { return static_cast<int>(this->Positions.rows()); }
  /// The sums over the vertices of each site of @p values (n).
  Eigen::VectorXd sums(const Eigen::VectorXd& values) const;
};

/// Every vertex is a site; those at the very same place are one.
TransportSites distinctSites(const Points2& positions);

/// About @p verticesPerSite >= 1 neighbours are one site at their centre of mass, @p masses (n, > 0).
/// The vertices in @p alone are sites of their own.
TransportSites groupedSites(const Points2& positions,
  const Eigen::VectorXd& masses,
  const std::vector<int>& alone,
  int verticesPerSite);

} // namespace flattening
