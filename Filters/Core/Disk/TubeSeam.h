// SPDX-License-Identifier: GPL-3.0-or-later
/// The choice of a seam that cuts a tube open from end to end.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// The two boundary loops (as in MeshTopology) that are the ends of a tube: the longest loop and the
/// next one, if that is at least a quarter as long. Empty if it is not, or if there are fewer than two
/// loops.
std::vector<int> endsOfTube(const Points3& vertices, const std::vector<std::vector<int>>& loops);

/// Two points for cutGeodesicSeam, one on either boundary loop of @p mesh, between which the geodesic is
/// a shortest one: it meets both loops at right angles, up to the length of an edge. A tube that is cut
/// there unrolls to a rectangle. The search starts with the shortest path along edges; then each end in
/// turn moves to the vertex of its loop that is nearest to the other end (GeodesicSearch), until neither
/// moves.
/// @throws TopologyError if no path joins the loops; Cancelled.
std::vector<Eigen::Vector3d> placeTubeSeam(const TriangleMesh& mesh,
  const std::vector<int>& firstLoop,
  const std::vector<int>& secondLoop,
  const ProgressCallback& progress = {});

} // namespace flattening
