// SPDX-License-Identifier: GPL-3.0-or-later
/// Shortest paths over the faces of a surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/EditableSurface.h"

#include <vector>

namespace flattening
{

/// Where a path passes: at a vertex, or between the ends of an edge.
struct PathPoint
{
  SurfaceMesh::Vertex_index Vertex; ///< null between the ends of an edge
  SurfaceMesh::Halfedge_index Edge; ///< null at a vertex
  double Fraction = 0.0;            ///< way from the edge's source to its target, in (0, 1)

  bool isVertex() const { return this->Vertex != SurfaceMesh::null_vertex(); }
};

struct GeodesicPath
{
  std::vector<PathPoint> Points; ///< both ends included; consecutive ones lie on one face
  double Length = 0.0;           ///< input units
};

/// The exact geodesic between two vertices (Xin, Wang 2009, "Improving Chen and Han's algorithm on the
/// discrete geodesic problem"; CGAL Surface_mesh_shortest_path) in a strip around the shortest edge
/// path. Strips around the path found take its place until it keeps off their border: then it is as
/// straight as the surface allows. A shorter one on the far side of a hill may exist.
/// @throws TopologyError if no path joins the vertices.
GeodesicPath geodesicPath(const SurfaceMesh& mesh,
  SurfaceMesh::Vertex_index from,
  SurfaceMesh::Vertex_index to,
  const ProgressCallback& progress = {});

} // namespace flattening
