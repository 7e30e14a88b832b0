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

// Cosine of 11 degrees: where faces are tilted more against each other, flipping their edge would
// visibly change the surface.
constexpr double FlatTilt = 0.98;
// The share by which the smallest angle must grow: a guard against rounding, which could flip an edge to
// and fro.
constexpr double FlipRounding = 1e-6;

bool flipImproves(const SurfaceMesh& mesh, Halfedge h)
{
  const Vertex left = mesh.target(mesh.next(h));
  const Vertex right = mesh.target(mesh.next(mesh.opposite(h)));
  const Point& p = mesh.point(mesh.source(h));
  const Point& q = mesh.point(mesh.target(h));
  const Point& r = mesh.point(left);
  const Point& s = mesh.point(right);
  const double before = std::min(smallestAngle({ p, q, r }), smallestAngle({ q, p, s }));
  const double after = std::min(smallestAngle({ s, q, r }), smallestAngle({ p, s, r }));
  if (!(after > (1.0 + FlipRounding) * before))
  {
    return false;
  }
  for (const Vector& old : { CGAL::cross_product(q - p, r - p), CGAL::cross_product(p - q, s - q) })
  {
    for (const Vector& now : { CGAL::cross_product(q - s, r - s), CGAL::cross_product(s - p, r - p) })
    {
      if (!isTiltedLess(old, now, FlatTilt))
      {
        return false;
      }
    }
  }
  return !mesh.halfedge(left, right).is_valid();
}

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

bool isTiltedLess(const Vector& a, const Vector& b, double cosine)
{
  return a * b > cosine * std::sqrt(a.squared_length() * b.squared_length());
}

bool flipWhileImproving(SurfaceMesh& mesh,
  const std::vector<Edge>& edges,
  const std::function<bool(Edge)>& mayFlip)
{
  bool changed = false;
  for (bool flipped = true; flipped;)
  {
    flipped = false;
    for (const Edge edge : edges)
    {
      const Halfedge h = mesh.halfedge(edge);
      if (!mesh.is_border(edge) && mayFlip(edge) && flipImproves(mesh, h))
      {
        CGAL::Euler::flip_edge(h, mesh);
        flipped = changed = true;
      }
    }
  }
  return changed;
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
      for (const Halfedge side : { h, mesh.prev(h) }) // one of the fan of faces, and one of its rim
      {
        edges.push_back(mesh.edge(side));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  flipWhileImproving(mesh,
    edges,
    [&](Edge edge)
    {
      const Halfedge h = mesh.halfedge(edge);
      return !(listed[mesh.source(h)] && listed[mesh.target(h)]) &&
             surface.origin(mesh.face(h)) == surface.origin(mesh.face(mesh.opposite(h)));
    });
}

} // namespace flattening
