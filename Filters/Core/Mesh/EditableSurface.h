// SPDX-License-Identifier: GPL-3.0-or-later
/// A manifold triangle surface whose connectivity can be edited while every vertex and face keeps track
/// of its origin: CGAL's half-edge mesh plus two property maps.
#pragma once

#include "Mesh/DerivedMesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <utility>
#include <vector>

namespace flattening
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Row @p v of @p points as a CGAL point.
inline Kernel::Point_3 pointOf(const Points3& points, Eigen::Index v)
{
  return { points(v, 0), points(v, 1), points(v, 2) };
}

/// A half-edge mesh with the same indices of vertices and faces. @p Point is Kernel::Point_3 or
/// Eigen::Vector3d. Parts that have a boundary may meet at a vertex. @throws TopologyError if the mesh
/// is otherwise not an oriented manifold.
template <typename Point = Kernel::Point_3>
CGAL::Surface_mesh<Point> toSurfaceMesh(const TriangleMesh& mesh);

/// The mesh without its removed elements, which are dropped from the numbering. @p Point is as above.
template <typename Point>
TriangleMesh toTriangleMesh(const CGAL::Surface_mesh<Point>& mesh);

class EditableSurface
{
public:
  using Vertex = SurfaceMesh::Vertex_index;
  using Halfedge = SurfaceMesh::Halfedge_index;
  using Face = SurfaceMesh::Face_index;

  struct Split
  {
    Vertex Middle; ///< the new vertex
    /// For each face beside the edge: the half that keeps its index, and the new face, its other half.
    std::vector<std::pair<Face, Face>> Halves;
  };

  explicit EditableSurface(const TriangleMesh& mesh);

  SurfaceMesh& mesh() { return this->Mesh; }
  const SurfaceMesh& mesh() const { return this->Mesh; }

  /// Splits the edge at source + t (target - source), 0 < t < 1, and the one or two faces beside it.
  /// The new faces inherit the origin of the face that they are a part of.
  /// @throws InvalidInput if the surface has more than twice its vertices and a million.
  Split splitEdge(Halfedge edge, double t);

  /// Whether the vertex was added where an edge was split.
  bool isNew(Vertex vertex) const { return static_cast<int>(vertex.idx()) >= this->OriginalVertices; }

  double squaredLength(Halfedge edge) const;
  double longestEdge(Face face) const; ///< length of the longest edge of the face
  double area(Face face) const;

  Origin& origin(Vertex vertex) { return this->VertexOrigin[vertex]; }
  /// The original face that the face is a part of; -1 for a face that was added.
  int origin(Face face) const { return this->FaceOrigin[face]; }

  /// The edited mesh, compacted, with its origins.
  DerivedMesh derived() const;

private:
  SurfaceMesh Mesh;
  SurfaceMesh::Property_map<Vertex, Origin> VertexOrigin;
  SurfaceMesh::Property_map<Face, int> FaceOrigin; // -1 for added faces
  int OriginalVertices;
};

} // namespace flattening
