// SPDX-License-Identifier: GPL-3.0-or-later
/// A triangle surface that can be cut along closed loops of edges and closed again by caps.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <array>
#include <utility>
#include <vector>

namespace flattening
{

/// Half-edges are numbered 3 f + k: side k of face f, from its vertex k to its vertex k + 1. Vertices
/// and faces are only ever added, so those of the mesh at the start keep their numbers.
class HalfedgeSurface
{
public:
  /// @throws TopologyError if @p mesh is not an oriented manifold.
  explicit HalfedgeSurface(const TriangleMesh& mesh);

  int vertexCount() const { return static_cast<int>(this->Points.size()); }
  int faceCount() const { return static_cast<int>(this->Origins.size() / 3); }
  int halfedgeCount() const { return static_cast<int>(this->Origins.size()); }

  static int face(int h) { return h / 3; }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int origin(int h) const { return this->Origins[h]; }
  int tip(int h) const { return this->Origins[next(h)]; }
  int twin(int h) const { return this->Twins[h]; } ///< -1 on the boundary
  double length(int h) const
  {
    return (this->point(this->tip(h)) - this->point(this->origin(h))).norm();
  }

  const Eigen::Vector3d& point(int v) const { return this->Points[v]; }
  Eigen::Vector3d& point(int v) { return this->Points[v]; }
  /// A half-edge that starts at @p v, on the boundary if v is; -1 for a vertex of no face.
  int outgoing(int v) const { return this->Outgoing[v]; }
  /// Whether @p v is on the boundary or belongs to no face.
  bool onBoundary(int v) const { return this->Outgoing[v] < 0 || this->Twins[this->Outgoing[v]] < 0; }

  /// The half-edge after @p h counter-clockwise about its origin; -1 past the boundary.
  int rotated(int h) const { return this->Twins[previous(h)]; }

  /// The half-edge from @p a to @p b or, if that is missing on the boundary, from b to a; -1 if the
  /// vertices are not neighbours.
  int edgeBetween(int a, int b) const;

  /// Vertices of each boundary loop in the direction of its half-edges (surface on the left).
  std::vector<std::vector<int>> boundaryLoops() const;

  /// Cuts along a closed loop of half-edges, each starting where the one before it ends, that meets no
  /// vertex twice and none on the boundary. Its vertices stay with the faces on its right; those on its
  /// left get copies: that of the origin of loop[i] is the returned number + i.
  int cut(const std::vector<int>& loop);

  int addVertex(const Eigen::Vector3d& point);

  /// Adds faces and joins them with each other and with the boundary.
  void addFaces(const std::vector<std::array<int, 3>>& faces);

  /// Splits an inner edge, and the faces beside it, at its middle. Returns the new vertex. Half-edge @p
  /// h becomes the half at its tip. Two faces are added, a part of face(h) first, then one of its
  /// twin's.
  int splitEdge(int h);

  /// Vertices in use - edges + faces.
  int eulerCharacteristic() const;

  TriangleMesh mesh() const;

private:
  void join(int h, int g);

  std::vector<Eigen::Vector3d> Points;
  std::vector<int> Origins;
  std::vector<int> Twins;
  std::vector<int> Outgoing;
};

} // namespace flattening
