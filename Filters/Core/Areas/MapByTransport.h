// SPDX-License-Identifier: GPL-3.0-or-later
/// One area-preserving map: the transport, the positions that it gives, and their refinement.
#pragma once

#include "Areas/AreaPreservingDisk.h"
#include "Areas/DomainTarget.h"

namespace flattening
{

/// The map of a disk to the domain of @p target.
/// @param conformal the conformal map (n x 2), whose transport to the domain is computed.
/// @param onDomain the conformal map, or another map to the domain with few faces flipped (n x 2).
/// @param weights of the vertices (n), or empty if all are 1.
/// @throws InvalidInput, ConvergenceError, Cancelled as areaPreservingDiskMap does.
AreaPreservingResult mapByTransport(const TriangleMesh& mesh,
  const Points2& conformal,
  const Points2& onDomain,
  const DomainTarget& target,
  const Eigen::VectorXd& weights,
  const AreaPreservingOptions& options,
  const ProgressCallback& progress = {});

/// The same without its refinement: the transport with the sites that the refinement takes, and the map
/// that it gives, in which faces may be flipped. In place of the conformal map, any map within the domain
/// may be given.
AreaPreservingResult transportedMap(const TriangleMesh& mesh,
  const Points2& conformal,
  const DomainTarget& target,
  const Eigen::VectorXd& weights,
  const AreaPreservingOptions& options,
  const ProgressCallback& progress = {});

} // namespace flattening
