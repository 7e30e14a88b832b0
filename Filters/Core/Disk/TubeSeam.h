// SPDX-License-Identifier: GPL-3.0-or-later
/// Where to cut a tube open from end to end.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// The two boundary loops (as in MeshTopology) that are the ends of a tube: the longest and the next
/// one, if that is at least a quarter as long. None otherwise, or if there are fewer loops.
std::vector<int> endsOfTube(const Points3& vertices, const std::vector<std::vector<int>>& loops);

/// The ends of a seam (for cutGeodesicSeam) between two boundary loops of @p mesh: boundary vertices
/// between which the geodesic is a shortest one, so that it meets both loops at right angles up to the
/// length of an edge. A tube cut there unrolls to a rectangle. The search begins at the shortest path
/// along edges and moves either end by Newton's method on the length (its derivative is the cosine of
/// the angle at which the geodesic arrives).
/// @throws TopologyError if no path joins the loops; Cancelled.
std::vector<Eigen::Vector3d> placeTubeSeam(const TriangleMesh& mesh,
  const std::vector<int>& firstLoop,
  const std::vector<int>& secondLoop,
  const ProgressCallback& progress = {});

} // namespace flattening
