// SPDX-License-Identifier: GPL-3.0-or-later
/// Triangulations of loops and holes, and their refinement, by CGAL. They stand here because the
/// templates take long to compile.
#pragma once

#include "Mesh/EditableSurface.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace flattening
{

/// The longest loop, in vertices, for which all triangulations are searched, O(n^3): this takes 3 s. A
/// guard for time. CGAL's faster search in a Delaunay triangulation is not used: where triangulations
/// are equally good, as for points of a grid or a circle, its choice depends on addresses in memory.
constexpr std::size_t LongestSearchedLoop = 500;

/// The triangulation of a closed loop of least dihedral angles and area (Liepa 2003, "Filling holes in
/// meshes"; CGAL triangulate_hole_polyline). The corners of its faces are numbers of points, ascending,
/// so that its sides have the direction of the loop. Empty if there is none, or if the loop has more
/// than LongestSearchedLoop points.
std::vector<std::array<int, 3>> triangulatedLoop(const std::vector<Eigen::Vector3d>& loop);

/// Covers the hole beside @p border as triangulatedLoop does, with the least angles to the faces around
/// it too, and returns the new faces (CGAL triangulate_hole). Of holes of more than LongestSearchedLoop
/// vertices a coarse polygon is searched first, and then each part between it and the hole's boundary.
/// Nothing changes, and no face is returned, if none is found, or if the hole is all around one
/// triangle, whose corners a second one would have too.
/// @param planar whether nearly flat holes get a constrained Delaunay triangulation of the plane.
std::vector<SurfaceMesh::Face_index> triangulateHole(SurfaceMesh& mesh,
  SurfaceMesh::Halfedge_index border,
  bool planar);

/// Adds vertices to the faces until they are as dense as the vertices around them (CGAL refine), and
/// returns the new vertices.
std::vector<SurfaceMesh::Vertex_index> refineFaces(SurfaceMesh& mesh,
  const std::vector<SurfaceMesh::Face_index>& faces);

} // namespace flattening
