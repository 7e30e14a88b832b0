// SPDX-License-Identifier: GPL-3.0-or-later
/// Distances over a surface along its edges: up to about 1.4 times too long, but fast, and good enough
/// to choose places.
#pragma once

#include "Mesh/EditableSurface.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace flattening
{

/// Searches from several places over the same surface (Dijkstra, Boost).
class DijkstraDistances
{
public:
  /// @param blocked one flag per vertex: not 0 where no path may run; none: anywhere.
  explicit DijkstraDistances(const SurfaceMesh& mesh, const std::vector<char>& blocked = {});
  ~DijkstraDistances();

  /// Of every vertex from the nearest source (input units); infinite where there is no way.
  Eigen::VectorXd from(const std::vector<SurfaceMesh::Vertex_index>& sources) const;

private:
  struct Graph;
  std::unique_ptr<Graph> Edges;
};

/// Of every vertex from the nearest flagged one (input units); infinite if none is flagged.
Eigen::VectorXd distancesFromFlagged(const SurfaceMesh& mesh, const std::vector<char>& flags);

/// The index of the largest value; compared in single precision, so that values equal up to rounding tie
/// and the first one wins.
int indexOfLargest(const Eigen::VectorXd& values);

} // namespace flattening
