// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/HoleTriangulation.h"

#include "Mesh/CgalVersions.h"

#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <iterator>

namespace flattening
{

namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;

} // namespace

std::vector<std::array<int, 3>> triangulatedLoop(const std::vector<Eigen::Vector3d>& loop)
{
  if (loop.size() > LongestSearchedLoop)
  {
    return {};
  }
  std::vector<Kernel::Point_3> points;
  for (const Eigen::Vector3d& p : loop)
  {
    points.emplace_back(p.x(), p.y(), p.z());
  }
  std::vector<CGAL::Triple<int, int, int>> triples;
  PMP::triangulate_hole_polyline(
    points, std::back_inserter(triples), CGAL::parameters::use_delaunay_triangulation(false));
  std::vector<std::array<int, 3>> faces;
  for (const auto& t : triples)
  {
    faces.push_back({ t.first, t.second, t.third });
  }
  return faces;
}

std::vector<SurfaceMesh::Face_index> triangulateHole(SurfaceMesh& mesh,
  SurfaceMesh::Halfedge_index border,
  bool planar)
{
  const bool isLong = mesh.vertices_around_face(border).size() > LongestSearchedLoop;
  std::vector<SurfaceMesh::Face_index> faces;
  triangulateHoleInto(mesh,
    border,
    std::back_inserter(faces),
    CGAL::parameters::use_2d_constrained_delaunay_triangulation(planar)
      .use_delaunay_triangulation(isLong)
      .do_not_use_cubic_algorithm(isLong));
  return faces;
}

std::vector<SurfaceMesh::Vertex_index> refineFaces(SurfaceMesh& mesh,
  const std::vector<SurfaceMesh::Face_index>& faces)
{
  std::vector<SurfaceMesh::Face_index> newFaces;
  std::vector<SurfaceMesh::Vertex_index> newVertices;
  PMP::refine(mesh, faces, std::back_inserter(newFaces), std::back_inserter(newVertices));
  return newVertices;
}

} // namespace flattening
