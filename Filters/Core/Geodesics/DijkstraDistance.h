// SPDX-License-Identifier: GPL-3.0-or-later
/// Distances along the edges of a surface: up to about 1.4 times too long, but computed fast, and good
/// enough to choose where to cut or open a surface.
#pragma once

#include "Mesh/EditableSurface.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace flattening
{

/// The distance of every vertex from the nearest source, along edges (n, input units; Dijkstra's
/// algorithm of Boost); infinite where no path leads.
/// @param blocked  one flag per vertex, not 0 where no path may run; if empty, paths may run anywhere
Eigen::VectorXd distancesAlongEdges(const SurfaceMesh& mesh,
  const std::vector<SurfaceMesh::Vertex_index>& sources,
  const std::vector<char>& blocked = {});

/// The target that is nearest to a source, and the distances of the vertices that are nearer than it.
struct NearestTarget
{
  SurfaceMesh::Vertex_index Vertex; ///< invalid if no path leads to a target
  Eigen::VectorXd Distances; ///< from the source, as distancesAlongEdges; of farther vertices too large
};

/// Looks for the target that is nearest to @p source along edges, and no farther.
/// @param blocked  as for distancesAlongEdges
NearestTarget nearestTarget(const SurfaceMesh& mesh,
  SurfaceMesh::Vertex_index source,
  const std::function<bool(SurfaceMesh::Vertex_index)>& isTarget,
  const std::vector<char>& blocked);

/// The distance of every vertex from the nearest flagged one (n, input units); infinite if none is
/// flagged.
Eigen::VectorXd distancesFromFlagged(const SurfaceMesh& mesh, const std::vector<char>& flags);

/// The vertices of a shortest path along edges from @p end to a source of @p distances, both ends
/// included. The distance of @p end must be finite. Of equal ways the first one around a vertex is
/// taken.
std::vector<int> shortestPath(const SurfaceMesh& mesh,
  const Eigen::VectorXd& distances,
  SurfaceMesh::Vertex_index end);

/// The index of the largest value. Values are compared in single precision, so that of values that
/// differ by rounding only the first one is chosen.
int indexOfLargest(const Eigen::VectorXd& values);

} // namespace flattening
