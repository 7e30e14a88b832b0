// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryConditioning.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

using Vertex = EditableSurface::Vertex;
using Halfedge = EditableSurface::Halfedge;
using Edge = SurfaceMesh::Edge_index;
using Face = EditableSurface::Face;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

constexpr double ShortShare = 0.8; // of the mean boundary edge
constexpr double VeryShortShare = 0.2;
constexpr double SmallestTilt = 0.5; // cosine of 60 degrees
constexpr double FlatTilt = 0.98;    // cosine of 11 degrees
constexpr double Rounding = 1e-6;    // of angles
constexpr double GoodAngle = 0.35;   // 20 degrees; a collapse need not leave a larger one

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

class BoundaryConditioner
{
public:
  BoundaryConditioner(EditableSurface& surface, int minimumVertices)
    : Surface(surface)
    , Mesh(surface.mesh())
    , MinimumVertices(minimumVertices)
  {
    double length = 0.0;
    for (const Halfedge h : this->Mesh.halfedges())
    {
      if (this->Mesh.is_border(h))
      {
        ++this->BoundaryVertices;
        length += std::sqrt(surface.squaredLength(h));
      }
    }
    const double mean = length / std::max(this->BoundaryVertices, 1);
    this->Short = ShortShare * ShortShare * mean * mean;
    this->VeryShort = VeryShortShare * VeryShortShare * mean * mean;
  }

  void run()
  {
    // A collapse or flip may be what another one waits for.
    do
    {
      this->Changed = false;
      this->collapseShortEdges();
      this->flipAtBoundary();
    } while (this->Changed);
  }

private:
  void collapseShortEdges()
  {
    for (const Vertex v : this->Mesh.vertices())
    {
      if (this->Mesh.is_border(v))
      {
        this->enqueueAround(v);
      }
    }
    while (!this->Queue.empty())
    {
      const auto [length, edge] = this->Queue.top();
      this->Queue.pop();
      if (!this->Mesh.is_removed(edge) &&
          length == static_cast<float>(this->Surface.squaredLength(this->Mesh.halfedge(edge))))
      {
        this->tryCollapse(edge);
      }
    }
  }

  // Turns edges beside the boundary over where that makes the smallest of the six angles larger and the
  // surface is nearly flat.
  void flipAtBoundary()
  {
    std::vector<Edge> edges;
    for (const Edge edge : this->Mesh.edges())
    {
      const Halfedge h = this->Mesh.halfedge(edge);
      if (!this->Mesh.is_border(edge) &&
          (this->Mesh.is_border(this->Mesh.source(h)) || this->Mesh.is_border(this->Mesh.target(h)) ||
            this->Mesh.is_border(this->Mesh.target(this->Mesh.next(h))) ||
            this->Mesh.is_border(this->Mesh.target(this->Mesh.next(this->Mesh.opposite(h))))))
      {
        edges.push_back(edge);
      }
    }
    bool flipped = true;
    while (flipped)
    {
      flipped = false;
      for (const Edge edge : edges)
      {
        if (this->flipImproves(this->Mesh.halfedge(edge)))
        {
          CGAL::Euler::flip_edge(this->Mesh.halfedge(edge), this->Mesh);
          flipped = true;
          this->Changed = true;
        }
      }
    }
  }

  bool flipImproves(Halfedge h) const
  {
    const Vertex a = this->Mesh.source(h);
    const Vertex b = this->Mesh.target(h);
    const Vertex c = this->Mesh.target(this->Mesh.next(h));
    const Vertex d = this->Mesh.target(this->Mesh.next(this->Mesh.opposite(h)));
    const Point& p = this->Mesh.point(a);
    const Point& q = this->Mesh.point(b);
    const Point& r = this->Mesh.point(c);
    const Point& s = this->Mesh.point(d);
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
    return !this->Mesh.halfedge(c, d).is_valid();
  }

  // Single precision, so that equal lengths up to rounding tie and go by index.
  using Candidate = std::pair<float, Edge>;

  void enqueueAround(Vertex v)
  {
    for (const Halfedge h : this->Mesh.halfedges_around_target(this->Mesh.halfedge(v)))
    {
      const double length = this->Surface.squaredLength(h);
      if (length < this->Short)
      {
        this->Queue.emplace(static_cast<float>(length), this->Mesh.edge(h));
      }
    }
  }

  void tryCollapse(Edge edge)
  {
    Halfedge h = this->Mesh.halfedge(edge); // source goes, target stays
    if (this->Mesh.is_border(edge))
    {
      if (this->BoundaryVertices <= this->MinimumVertices)
      {
        return;
      }
    }
    else
    {
      if (this->Mesh.is_border(this->Mesh.source(h)))
      {
        h = this->Mesh.opposite(h);
      }
      if (this->Mesh.is_border(this->Mesh.source(h)))
      {
        return; // a chord between boundary vertices
      }
    }
    // An inner vertex all but on the curve may become a boundary vertex where it is.
    if (!this->improves(h) &&
        (this->Mesh.is_border(edge) || this->Surface.squaredLength(h) < this->VeryShort))
    {
      h = this->Mesh.opposite(h);
    }
    if (!this->improves(h) || !CGAL::Euler::does_satisfy_link_condition(edge, this->Mesh))
    {
      return;
    }
    const Vertex stays = this->Mesh.target(h);
    const Point position = this->Mesh.point(stays);
    const EditableSurface::Origin origin = this->Surface.origin(stays);
    this->BoundaryVertices -= this->Mesh.is_border(edge);
    const Vertex kept = CGAL::Euler::collapse_edge(edge, this->Mesh);
    this->Mesh.point(kept) = position;
    this->Surface.origin(kept) = origin;
    this->enqueueAround(kept);
    this->Changed = true;
  }

  // Whether the faces around the source keep their side and a smallest angle no worse if it moves to the
  // target.
  bool improves(Halfedge h) const
  {
    const Vertex goes = this->Mesh.source(h);
    const Vertex stays = this->Mesh.target(h);
    double before = HUGE_VAL;
    double after = HUGE_VAL;
    for (const Face face : this->Mesh.faces_around_target(this->Mesh.opposite(h)))
    {
      if (face == SurfaceMesh::null_face())
      {
        continue;
      }
      std::array<Point, 3> corners;
      std::array<Point, 3> moved;
      bool vanishes = false;
      int k = 0;
      for (const Vertex v : this->Mesh.vertices_around_face(this->Mesh.halfedge(face)))
      {
        vanishes |= v == stays;
        corners[k] = this->Mesh.point(v);
        moved[k++] = this->Mesh.point(v == goes ? stays : v);
      }
      before = std::min(before, smallestAngle(corners));
      if (vanishes)
      {
        continue;
      }
      const Vector old = CGAL::cross_product(corners[1] - corners[0], corners[2] - corners[0]);
      const Vector now = CGAL::cross_product(moved[1] - moved[0], moved[2] - moved[0]);
      if (!(old * now > SmallestTilt * std::sqrt(old.squared_length() * now.squared_length())))
      {
        return false;
      }
      after = std::min(after, smallestAngle(moved));
    }
    return after >= (1.0 - Rounding) * std::min(before, GoodAngle);
  }

  EditableSurface& Surface;
  SurfaceMesh& Mesh;
  int MinimumVertices;
  int BoundaryVertices = 0;
  double Short = 0.0; // squared length
  double VeryShort = 0.0;
  bool Changed = false;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> Queue;
};

} // namespace

void conditionBoundary(EditableSurface& surface, int minimumVertices)
{
  BoundaryConditioner(surface, minimumVertices).run();
}

} // namespace flattening
