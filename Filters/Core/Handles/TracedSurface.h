// SPDX-License-Identifier: GPL-3.0-or-later
/// A surface under cuts whose vertices and faces remember where they came from.
#pragma once

#include "Handles/HalfedgeSurface.h"
#include "Mesh/DerivedMesh.h"

#include <array>
#include <utility>
#include <vector>

namespace flattening
{

class TracedSurface
{
public:
  /// Weights of original vertices; sum 1.
  using Origin = std::vector<std::pair<int, double>>;

  /// @throws TopologyError if @p mesh is not an oriented manifold.
  explicit TracedSurface(const TriangleMesh& mesh);

  const HalfedgeSurface& halfedges() const { return this->Halfedges; }
  /// Moves a vertex; its origin stays.
  void move(int v, const Eigen::Vector3d& place) { this->Halfedges.point(v) = place; }
  Origin origin(int v) const;

  /// See HalfedgeSurface.
  int cut(const std::vector<int>& loop);
  int splitEdge(int h);

  int addVertex(const Eigen::Vector3d& point, Origin origin);
  /// Their origin is -1.
  void addFaces(const std::vector<std::array<int, 3>>& faces);

  DerivedMesh derived() const;

private:
  HalfedgeSurface Halfedges;
  int OriginalVertices;
  std::vector<Origin> NewVertices; // of those after the original ones
  std::vector<int> Faces;
};

} // namespace flattening
