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

/// Row @p v as a CGAL point.
inline Kernel::Point_3 pointOf(const Points3& points, Eigen::Index v)
{
  return { points(v, 0), points(v, 1), points(v, 2) };
}

/// Vertex and face indices stay the same. @throws TopologyError if the mesh is not an oriented manifold.
SurfaceMesh toSurfaceMesh(const TriangleMesh& mesh);

/// The mesh without its removed elements, which are dropped from the numbering.
TriangleMesh toTriangleMesh(const SurfaceMesh& mesh);

class EditableSurface
{
public:
  using Vertex = SurfaceMesh::Vertex_index;
  using Halfedge = SurfaceMesh::Halfedge_index;
  using Face = SurfaceMesh::Face_index;
  /// Weights of original vertices; sum 1.
  using Origin = std::vector<std::pair<int, double>>;

  struct Split
  {
    Vertex Middle;
    /// Per face beside the edge: what now has its index, and the new face that is the rest of it.
    std::vector<std::pair<Face, Face>> Halves;
  };

  explicit EditableSurface(const TriangleMesh& mesh);

  SurfaceMesh& mesh() { return this->Mesh; }
  const SurfaceMesh& mesh() const { return this->Mesh; }

  /// Splits the edge at source + t (target - source), 0 < t < 1, and the one or two faces beside it.
  /// The new faces inherit the origin of the face that they are a part of.
  Split splitEdge(Halfedge edge, double t);

  double squaredLength(Halfedge edge) const;
  double longestEdge(Face face) const;
  double area(Face face) const;

  Origin& origin(Vertex vertex) { return this->VertexOrigin[vertex]; }
  int origin(Face face) const { return this->FaceOrigin[face]; }

  /// The edited mesh, compacted, with its origins.
  DerivedMesh derived() const;

private:
  SurfaceMesh Mesh;
  SurfaceMesh::Property_map<Vertex, Origin> VertexOrigin;
  SurfaceMesh::Property_map<Face, int> FaceOrigin; // -1 unless set
  int OriginalVertices;
};

} // namespace flattening
