// SPDX-License-Identifier: GPL-3.0-or-later
/// Shortest paths over the faces of a surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/EditableSurface.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// A point of a path: a vertex, or a point between the ends of an edge.
struct PathPoint
{
  SurfaceMesh::Vertex_index Vertex; ///< null between the ends of an edge
  SurfaceMesh::Halfedge_index Edge; ///< null at a vertex
  double Fraction = 0.0;            ///< share of the way from the edge's source to its target, in (0, 1)

  bool isVertex() const { return this->Vertex != SurfaceMesh::null_vertex(); }
};

/// The position of a point of a path, input units.
Eigen::Vector3d positionOf(const SurfaceMesh& mesh, const PathPoint& point);

/// A path over faces.
struct GeodesicPath
{
  std::vector<PathPoint> Points; ///< both ends included; consecutive ones lie on one face
  double Length = 0.0;           ///< input units
};

/// The exact geodesic between two vertices (see GeodesicSearch) in a strip around the shortest edge
/// path. While the path touches the strip's border, it is sought again in a strip around itself that is
/// half as wide again; in the end it is as straight as the surface allows. A shorter one on the far side
/// of a hill may exist. From a vertex to itself it is that vertex.
/// @param near vertices of a connected way to begin with in place of the shortest edge path; may be
/// empty
/// @throws TopologyError if no path joins the vertices, or rounding breaks the search; Cancelled.
GeodesicPath geodesicPath(const SurfaceMesh& mesh,
  SurfaceMesh::Vertex_index from,
  SurfaceMesh::Vertex_index to,
  const ProgressCallback& progress = {},
  const std::vector<SurfaceMesh::Vertex_index>& near = {});

/// The vertices of a path, and the ends of the edges that it crosses.
std::vector<SurfaceMesh::Vertex_index> verticesAlong(const SurfaceMesh& mesh,
  const std::vector<PathPoint>& path);

} // namespace flattening
