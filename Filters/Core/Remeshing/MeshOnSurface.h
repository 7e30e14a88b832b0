// SPDX-License-Identifier: GPL-3.0-or-later
/// A triangle mesh whose vertices move over an older surface: the state of remeshing and its local
/// operations.
#pragma once

#include "Base/Progress.h"
#include "Mesh/ClosestPointWalk.h"
#include "Mesh/DerivedMesh.h"

#include <CGAL/Surface_mesh.h>
#include <boost/container/small_vector.hpp>

#include <Eigen/Core>

#include <array>
#include <functional>

namespace flattening
{

/// A corner of a triangle as it is or as an operation would make it; lives no longer than that question.
struct Corner
{
  int Vertex;
  const Eigen::Vector3d* Position;
  const Eigen::Vector3d* Normal; ///< of the old surface there
};

using CornerTriangle = std::array<Corner, 3>;

/// What an operation would do: the triangles that it takes away and those that take their place.
struct LocalChange
{
  using Triangles = boost::container::small_vector<CornerTriangle, 16>;
  boost::container::small_vector<int, 16> Removed; ///< their faces
  Triangles Before;
  Triangles After;
};

class MeshOnSurface
{
public:
  using Mesh = CGAL::Surface_mesh<Eigen::Vector3d>;
  using Vertex = Mesh::Vertex_index;
  using Halfedge = Mesh::Halfedge_index;
  using Edge = Mesh::Edge_index;
  using Face = Mesh::Face_index;
  /// Decides whether an operation is done.
  using Guard = std::function<bool(const LocalChange&)>;

  /// Starts as the old surface, which must outlive it. @throws TopologyError if that is no oriented
  /// manifold.
  explicit MeshOnSurface(const TriangleMesh& old);

  const Mesh& mesh() const { return this->Surface; }
  const ClosestPointWalk& walk() const { return this->Walk; }
  bool onBoundary(Vertex v) const { return this->Boundary[v] != 0; }
  const SurfacePoint& place(Vertex v) const { return this->Place[v]; }
  Corner corner(Vertex v) const;
  CornerTriangle triangle(Face f) const;
  double length(Halfedge h) const;

  /// Splits an edge at its middle, which is moved onto the old surface if @p guard admits it and the
  /// edge is not on the boundary. Always succeeds.
  Vertex split(Edge edge, const Guard& guard);

  /// Replaces an edge between two faces by the other diagonal.
  bool flip(Edge edge, const Guard& guard);

  /// Moves an interior vertex to a place on the old surface or, with @p position, beside it.
  bool move(Vertex vertex, const SurfacePoint& to, const Eigen::Vector3d& position, const Guard& guard);

  /// Merges the ends of an edge at its middle on the old surface or at one of its ends, the first that
  /// @p guard admits; a boundary keeps its vertices, except along an almost straight part of it.
  bool collapse(Edge edge, const Guard& guard);

  /// The mesh, compacted; vertices are made of the old face below them, faces are parts of the old face
  /// nearest to their centroids.
  DerivedMesh derived(const ProgressCallback& progress = {}) const;

private:
  struct Target
  {
    Eigen::Vector3d Position;
    SurfacePoint Place;
  };

  LocalChange changeByCollapsing(Halfedge h, const Corner& to) const;
  void gatherStar(Vertex v, Vertex except, const Corner& to, LocalChange& change) const;
  bool straightAround(Halfedge border) const;
  void set(Vertex v, const Eigen::Vector3d& position, const SurfacePoint& place);

  const TriangleMesh& Old;
  ClosestPointWalk Walk;
  Mesh Surface;
  Mesh::Property_map<Vertex, SurfacePoint> Place;
  Mesh::Property_map<Vertex, Eigen::Vector3d> Normal;
  Mesh::Property_map<Vertex, char> Boundary;
};

/// Smallest of the sines of the triangle's angles; 0 if it has no area.
double smallestSine(const CornerTriangle& triangle);

/// Cosine between the triangle's normal and the mean of the old surface's normals at its corners.
double alignment(const CornerTriangle& triangle);

/// The smallest over the triangles; 1 if there is none.
double smallestSine(const LocalChange::Triangles& triangles);
double smallestAlignment(const LocalChange::Triangles& triangles);

} // namespace flattening
