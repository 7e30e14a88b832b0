// SPDX-License-Identifier: GPL-3.0-or-later
/// Makes points and paths on a surface vertices and edges of its mesh; the surface keeps its shape.
#pragma once

#include "Geodesics/GeodesicPath.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/EditableSurface.h"

#include <functional>
#include <vector>

namespace flattening
{

/// Makes a point of the surface a vertex, after longest-edge bisection of the face there down to edges
/// of length @p longestEdge (input units). A vertex or an edge closer than a fifth of the face's size is
/// used instead of a new one inside the face.
/// @param point with the index of its face in the original mesh.
SurfaceMesh::Vertex_index insertPoint(EditableSurface& surface,
  const SurfacePoint& point,
  double longestEdge);

/// Leads a path through the vertices that it passes closer than a fifth of the edge that it crosses
/// there, so that it cuts no slivers off. Vertices for which @p avoided is true are passed at that
/// distance instead. The ends stay, and consecutive points still lie on one face.
void snapToVertices(const SurfaceMesh& mesh,
  std::vector<PathPoint>& path,
  const std::function<bool(SurfaceMesh::Vertex_index)>& avoided);

/// Splits the edges that the path crosses. Returns its vertices; edges join consecutive ones.
std::vector<SurfaceMesh::Vertex_index> insertPath(EditableSurface& surface,
  const std::vector<PathPoint>& path);

} // namespace flattening
