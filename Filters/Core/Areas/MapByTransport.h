// SPDX-License-Identifier: GPL-3.0-or-later
/// One area-preserving map: the transport, the positions that it gives, and their refinement.
#pragma once

#include "Areas/AreaPreservingDisk.h"
#include "Areas/DomainTarget.h"

namespace flattening
{

/// A surface, and the map that it is to have. The parts must outlive it.
struct MapProblem
{
  const TriangleMesh& Mesh; ///< a disk
  const DomainTarget& Target;
  const Eigen::VectorXd& Weights; ///< of the vertices (n), or empty if all are 1
  const AreaPreservingOptions& Options;
};

/// The maps that another one is made from. They must outlive it.
struct MapStart
{
  const Points2& Conformal; ///< the conformal map (n x 2), whose transport to the domain is computed
  const Points2& OnDomain;  ///< the same, or another map to the domain with few faces flipped (n x 2)
};

/// The map of a disk to a domain.
/// @throws InvalidInput, ConvergenceError, Cancelled as areaPreservingDiskMap does.
AreaPreservingResult mapByTransport(const MapProblem& problem,
  const MapStart& start,
  const ProgressCallback& progress = {});

/// The same without its refinement: the transport with the sites that the refinement takes, and the map
/// that it gives, in which faces may be flipped. @p start may be any map within the domain.
AreaPreservingResult transportedMap(const MapProblem& problem,
  const Points2& start,
  const ProgressCallback& progress = {});

} // namespace flattening
