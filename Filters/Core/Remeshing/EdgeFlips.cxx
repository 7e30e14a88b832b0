// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/EdgeFlips.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

using Vertex = SurfaceMesh::Vertex_index;
using Halfedge = SurfaceMesh::Halfedge_index;
using Edge = SurfaceMesh::Edge_index;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

constexpr double FlatTilt = 0.98; // cosine of 11 degrees
constexpr double Rounding = 1e-6; // of angles

} // namespace

double smallestAngle(const std::array<Point, 3>& corners)
{
  double smallest = HUGE_VAL;
  for (int k = 0; k < 3; ++k)
  {
    const Vector u = corners[(k + 1) % 3] - corners[k];
    const Vector v = corners[(k + 2) % 3] - corners[k];
    const double sine = std::sqrt(CGAL::cross_product(u, v).squared_length());
    smallest = std::min(smallest, std::atan2(sine, u * v));
  }
  return smallest;
}

bool flipImproves(const SurfaceMesh& mesh, SurfaceMesh::Halfedge_index h)
{
  const auto a = mesh.source(h);
  const auto b = mesh.target(h);
  const auto c = mesh.target(mesh.next(h));
  const auto d = mesh.target(mesh.next(mesh.opposite(h)));
  const Point& p = mesh.point(a);
  const Point& q = mesh.point(b);
  const Point& r = mesh.point(c);
  const Point& s = mesh.point(d);
  const double before = std::min(smallestAngle({ p, q, r }), smallestAngle({ q, p, s }));
  const double after = std::min(smallestAngle({ s, q, r }), smallestAngle({ p, s, r }));
  if (!(after > (1.0 + Rounding) * before))
  {
    return false;
  }
  const Vector first = CGAL::cross_product(q - p, r - p);
  const Vector second = CGAL::cross_product(p - q, s - q);
  const Vector third = CGAL::cross_product(q - s, r - s);
  const Vector fourth = CGAL::cross_product(s - p, r - p);
  for (const Vector& old : { first, second })
  {
    for (const Vector& now : { third, fourth })
    {
      if (!(old * now > FlatTilt * std::sqrt(old.squared_length() * now.squared_length())))
      {
        return false;
      }
    }
  }
  return !mesh.halfedge(c, d).is_valid();
}

void flipInsideOriginalFaces(EditableSurface& surface, const std::vector<Vertex>& vertices)
{
  SurfaceMesh& mesh = surface.mesh();
  std::vector<char> listed(mesh.num_vertices(), 0);
  for (const Vertex v : vertices)
  {
    listed[v] = 1;
  }
  std::vector<Edge> edges;
  for (const Vertex v : vertices)
  {
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      for (const Halfedge side : { h, mesh.prev(h) }) // of the fan, and around it
      {
        edges.push_back(mesh.edge(side));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  bool flipped = true;
  while (flipped)
  {
    flipped = false;
    for (const Edge edge : edges)
    {
      const Halfedge h = mesh.halfedge(edge);
      if (mesh.is_border(edge) || (listed[mesh.source(h)] && listed[mesh.target(h)]) ||
          surface.origin(mesh.face(h)) != surface.origin(mesh.face(mesh.opposite(h))))
      {
        continue;
      }
      if (flipImproves(mesh, h))
      {
        CGAL::Euler::flip_edge(h, mesh);
        flipped = true;
      }
    }
  }
}

} // namespace flattening
