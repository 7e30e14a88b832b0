// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/HoleTriangulation.h"

#include "Mesh/CgalVersions.h"

#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace flattening
{

namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;

using Halfedge = SurfaceMesh::Halfedge_index;
using Corners = std::array<int, 3>;

// The number of corners of the coarse polygon in a longer loop. A choice: all triangulations of so many
// are searched within 0.2 s.
constexpr std::size_t CoarseCorners = 200;

// Appends the best of all triangulations of the points with these numbers. Returns whether there is one.
bool searchTriangulation(const std::vector<Eigen::Vector3d>& loop,
  const std::vector<int>& numbers,
  std::vector<Corners>& faces)
{
  std::vector<Kernel::Point_3> points;
  for (const int i : numbers)
  {
    points.emplace_back(loop[i].x(), loop[i].y(), loop[i].z());
  }
  std::vector<CGAL::Triple<int, int, int>> triples;
  PMP::triangulate_hole_polyline(
    points, std::back_inserter(triples), CGAL::parameters::use_delaunay_triangulation(false));
  for (const auto& t : triples)
  {
    faces.push_back({ numbers[t.first], numbers[t.second], numbers[t.third] });
  }
  return triples.size() + 2 == numbers.size();
}

// The same for a part of a loop of any length, given by the numbers of its points: a coarse polygon of
// some of them, and what lies between it and the loop.
bool triangulateCoarsely(const std::vector<Eigen::Vector3d>& loop,
  const std::vector<int>& numbers,
  std::vector<Corners>& faces)
{
  if (numbers.size() <= CoarseCorners)
  {
    return searchTriangulation(loop, numbers, faces);
  }
  const std::size_t step = (numbers.size() + CoarseCorners - 1) / CoarseCorners;
  std::vector<int> coarse;
  for (std::size_t begin = 0; begin < numbers.size(); begin += step)
  {
    coarse.push_back(numbers[begin]);
    std::vector<int> between;
    for (std::size_t i = begin; i <= std::min(begin + step, numbers.size()); ++i)
    {
      between.push_back(numbers[i % numbers.size()]);
    }
    if (between.size() > 2 && !triangulateCoarsely(loop, between, faces))
    {
      return false;
    }
  }
  return searchTriangulation(loop, coarse, faces);
}

// Covers the hole with faces, the corners of which are numbers of the half-edges around it, and stand
// for their targets. Nothing changes, and no face is returned, if the mesh has one of the inner edges
// already.
std::vector<SurfaceMesh::Face_index> insertFaces(SurfaceMesh& mesh,
  const std::vector<Halfedge>& border,
  std::vector<Corners> faces)
{
  // A face that spans fewer edges of the loop is an ear of what the shorter ones leave.
  for (Corners& corners : faces)
  {
    std::sort(corners.begin(), corners.end());
  }
  std::sort(faces.begin(),
    faces.end(),
    [](const Corners& a, const Corners& b)
    { return std::pair(a[2] - a[0], a[0]) < std::pair(b[2] - b[0], b[0]); });
  const Corners last = faces.back();
  faces.pop_back();
  for (const Corners& corners : faces)
  {
    if (mesh.halfedge(mesh.target(border[corners[0]]), mesh.target(border[corners[2]])).is_valid())
    {
      return {};
    }
  }
  std::vector<SurfaceMesh::Face_index> inserted;
  std::vector<Halfedge> to = border; // per point: the half-edge to it around what is left of the hole
  CGAL::Euler::fill_hole(border.front(), mesh);
  for (const Corners& corners : faces)
  {
    to[corners[2]] = CGAL::Euler::split_face(to[corners[0]], to[corners[2]], mesh);
    inserted.push_back(mesh.face(mesh.opposite(to[corners[2]])));
  }
  inserted.push_back(mesh.face(to[last[0]]));
  return inserted;
}

std::vector<SurfaceMesh::Face_index> coverLongHole(SurfaceMesh& mesh, Halfedge border)
{
  std::vector<Halfedge> around;
  std::vector<Eigen::Vector3d> loop;
  std::vector<int> numbers;
  for (const Halfedge h : mesh.halfedges_around_face(border))
  {
    const Kernel::Point_3& p = mesh.point(mesh.target(h));
    numbers.push_back(static_cast<int>(around.size()));
    around.push_back(h);
    loop.emplace_back(p.x(), p.y(), p.z());
  }
  std::vector<Corners> faces;
  return triangulateCoarsely(loop, numbers, faces) ? insertFaces(mesh, around, std::move(faces))
                                                   : std::vector<SurfaceMesh::Face_index>();
}

// Whether the hole is all around one triangle.
bool surroundsTriangle(const SurfaceMesh& mesh, Halfedge border)
{
  const Halfedge within = mesh.opposite(border);
  return mesh.degree(mesh.face(within)) == 3 && mesh.is_border(mesh.opposite(mesh.next(within))) &&
         mesh.is_border(mesh.opposite(mesh.prev(within)));
}

} // namespace

std::vector<std::array<int, 3>> triangulatedLoop(const std::vector<Eigen::Vector3d>& loop)
{
  std::vector<Corners> faces;
  if (loop.size() <= LongestSearchedLoop)
  {
    std::vector<int> numbers(loop.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    searchTriangulation(loop, numbers, faces);
  }
  return faces;
}

std::vector<SurfaceMesh::Face_index> triangulateHole(SurfaceMesh& mesh,
  SurfaceMesh::Halfedge_index border,
  bool planar)
{
  if (surroundsTriangle(mesh, border))
  {
    return {};
  }
  const bool isLong = mesh.vertices_around_face(border).size() > LongestSearchedLoop;
  std::vector<SurfaceMesh::Face_index> faces;
  triangulateHoleInto(mesh,
    border,
    std::back_inserter(faces),
    CGAL::parameters::use_2d_constrained_delaunay_triangulation(planar)
      .use_delaunay_triangulation(false)
      .do_not_use_cubic_algorithm(isLong));
  return faces.empty() && isLong ? coverLongHole(mesh, border) : faces;
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
