// SPDX-License-Identifier: GPL-3.0-or-later
/// A triangle mesh whose vertices move over an older surface, with the local operations of remeshing.
/// EditableSurface, by contrast, changes only the connectivity and combines the origins exactly.
#pragma once

#include "Base/Progress.h"
#include "Mesh/ClosestPointWalk.h"
#include "Mesh/DerivedMesh.h"
#include "Remeshing/LocalChange.h"
#include "Remeshing/PlacedMesh.h"

#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <vector>

namespace flattening
{

class MeshOnSurface
{
public:
  using Mesh = CGAL::Surface_mesh<Eigen::Vector3d>;
  using Vertex = Mesh::Vertex_index;
  using Halfedge = Mesh::Halfedge_index;
  using Edge = Mesh::Edge_index;
  using Face = Mesh::Face_index;
  /// Decides whether an operation is carried out.
  using Guard = std::function<bool(const LocalChange&)>;

  /// Starts as a copy of the old surface, which must outlive the mesh. @throws TopologyError if that is
  /// no oriented manifold or has a vertex without faces.
  explicit MeshOnSurface(const TriangleMesh& old);

  /// Starts as @p present on the surface of @p walk.
  /// @param kept  per vertex, or empty: whether it stays where it is. No edge between two such vertices
  /// is
  ///        changed or made. @throws TopologyError as above.
  MeshOnSurface(std::shared_ptr<const ClosestPointWalk> walk,
    const PlacedMesh& present,
    const std::vector<char>& kept = {});

  const Mesh& mesh() const { return this->Surface; }
  const ClosestPointWalk& walk() const { return *this->Walk; }
  bool onBoundary(Vertex v) const { return this->Boundary[v] != 0; }
  /// The point of the old surface that the vertex lies on or, if it was moved off, belongs to.
  const SurfacePoint& place(Vertex v) const { return this->Place[v]; }
  Corner corner(Vertex v) const;
  CornerTriangle triangle(Face f) const;
  double length(Halfedge h) const;
  /// The mean of the positions of the vertices at the other ends of the edges.
  Eigen::Vector3d meanOfNeighbours(Vertex v) const;

  /// Splits an edge at its middle. Unless the edge is on the boundary, the middle moves onto the old
  /// surface if that is near and @p guard admits it. Returns the new vertex.
  Vertex split(Edge edge, const Guard& guard);

  /// Replaces an edge between two faces by the other diagonal. Returns whether that was done.
  bool flip(Edge edge, const Guard& guard);

  /// Moves an interior vertex to @p position, and its place on the old surface to @p to.
  /// Returns whether that was done.
  bool move(Vertex vertex, const SurfacePoint& to, const Eigen::Vector3d& position, const Guard& guard);

  /// Merges the ends of an edge at the first of these positions that @p guard admits: its middle on the
  /// old surface or one of its ends. Boundary vertices stay where they are, and are removed only where
  /// the boundary is almost straight. Returns whether that was done.
  bool collapse(Edge edge, const Guard& guard);

  /// The mesh without removed elements. Every vertex is made of the corners of the old face that its
  /// place lies on, and of a single one only if it is where that is; the origin of a face is the old
  /// face nearest to its centroid.
  DerivedMesh derived(const ProgressCallback& progress = {}) const;

  /// The mesh without removed elements, whose vertices keep their order, with its places.
  PlacedMesh placed() const;

private:
  struct Target
  {
    Eigen::Vector3d Position;
    SurfacePoint Place;
  };

  explicit MeshOnSurface(std::shared_ptr<const ClosestPointWalk> walk);
  LocalChange changeByCollapsing(Halfedge h, const Corner& to) const;
  void gatherStar(Vertex v, Vertex except, const Corner& to, LocalChange& change) const;
  bool straightAround(Halfedge border) const;
  bool bothKept(Vertex a, Vertex b) const { return this->Kept[a] != 0 && this->Kept[b] != 0; }
  bool makesKeptEdge(Halfedge h) const;
  // The normal is that of the old surface at the place.
  void set(Vertex v,
    const Eigen::Vector3d& position,
    const SurfacePoint& place,
    const Eigen::Vector3d& normal)
  {
    this->Surface.point(v) = position;
    this->Place[v] = place;
    this->Normal[v] = normal;
  }
  Origin originOfVertex(Vertex v) const;
  bool isOld(Face f) const;
  int originOfFace(Face f) const;

  std::shared_ptr<const ClosestPointWalk> Walk;
  const TriangleMesh& Old;
  Mesh Surface;
  Mesh::Property_map<Vertex, SurfacePoint> Place;
  Mesh::Property_map<Vertex, Eigen::Vector3d> Normal;
  Mesh::Property_map<Vertex, char> Boundary;
  Mesh::Property_map<Vertex, char> Kept;
};

} // namespace flattening
