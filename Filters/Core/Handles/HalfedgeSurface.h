// SPDX-License-Identifier: GPL-3.0-or-later
/// A triangle surface that can be cut along closed loops of edges and closed again by caps, and whose
/// vertices and faces remember the mesh that they come from.
#pragma once

#include "Mesh/DerivedMesh.h"
#include "Mesh/Halfedges.h"

#include <array>
#include <vector>

namespace flattening
{

/// Half-edges are numbered 3 f + k: side k of face f, from its vertex k to its vertex k + 1. Vertices
/// and faces are only ever added, so those of the original mesh keep their numbers.
class HalfedgeSurface
{
public:
  /// @param mesh  an oriented manifold (analyseTopology checks that)
  explicit HalfedgeSurface(const TriangleMesh& mesh);

  int vertexCount() const { return static_cast<int>(this->Points.size()); }
  int faceCount() const { return static_cast<int>(this->Sources.size() / 3); }
  int halfedgeCount() const { return static_cast<int>(this->Sources.size()); }

  static int face(int h) { return h / 3; }
  static int next(int h) { return nextHalfedge(h); }
  static int previous(int h) { return previousHalfedge(h); }
  int source(int h) const { return this->Sources[h]; }
  int target(int h) const { return this->Sources[next(h)]; }
  int twin(int h) const { return this->Twins[h]; } ///< -1 on the boundary
  double length(int h) const
  {
    return (this->point(this->target(h)) - this->point(this->source(h))).norm();
  }

  const Eigen::Vector3d& point(int v) const { return this->Points[v]; }
  /// Moves a vertex; its origin stays.
  void move(int v, const Eigen::Vector3d& point) { this->Points[v] = point; }
  /// The original vertices that @p v is made of. Where a cut copied a vertex, the copy has the same
  /// origin as that vertex.
  Origin origin(int v) const;

  /// A half-edge that starts at @p v, on the boundary if v is; -1 for a vertex of no face.
  int outgoing(int v) const { return this->Outgoing[v]; }
  /// Whether @p v is on the boundary or belongs to no face.
  bool onBoundary(int v) const { return this->Outgoing[v] < 0 || this->Twins[this->Outgoing[v]] < 0; }

  /// The next half-edge counter-clockwise about the source of @p h; -1 if the boundary comes next.
  int rotated(int h) const { return this->Twins[previous(h)]; }

  /// Calls visit(h) for each half-edge that starts at @p v, counter-clockwise from outgoing(v).
  template <typename Visit>
  void visitOutgoing(int v, const Visit& visit) const
  {
    const int first = this->Outgoing[v];
    for (int h = first; h >= 0;)
    {
      visit(h);
      h = this->rotated(h);
      h = h == first ? -1 : h;
    }
  }

  /// The half-edge from @p a to @p b. On the boundary, an edge has a half-edge in one direction only: if
  /// the one from a to b does not exist, returns the one from b to a. Returns -1 if the vertices are not
  /// neighbours.
  int edgeBetween(int a, int b) const;

  /// Vertices of each boundary loop in the direction of its half-edges (surface on the left).
  std::vector<std::vector<int>> boundaryLoops() const;

  /// Cuts along a closed loop of half-edges, each of which starts where the one before it ends. The loop
  /// must not meet a vertex twice or a vertex on the boundary. The vertices of the loop stay with the
  /// faces on its right; the faces on its left get copies of them. Returns the number of the first copy:
  /// the source of loop[i] has the copy with this number plus i.
  int cut(const std::vector<int>& loop);

  /// Returns the number of the new vertex.
  int addVertex(const Eigen::Vector3d& point, Origin origin = {});

  /// Adds faces of origin -1 and joins them with each other and with the boundary.
  void addFaces(const std::vector<std::array<int, 3>>& faces);

  /// Splits an inner edge, and the faces beside it, at its middle. Returns the new vertex. Half-edge @p
  /// h keeps its target and afterwards starts at the new vertex. Two faces are added: first a part of
  /// face(h), then a part of the face of its twin.
  int splitEdge(int h);

  TriangleMesh mesh() const;
  DerivedMesh derived() const;

private:
  void findOutgoing(int firstHalfedge);
  void join(int h, int g);

  std::vector<Eigen::Vector3d> Points;
  std::vector<int> Sources;
  std::vector<int> Twins;
  std::vector<int> Outgoing;
  int OriginalVertices;
  std::vector<Origin> NewOrigins; // of the vertices after the original ones
  std::vector<int> FaceOrigins;
};

} // namespace flattening
