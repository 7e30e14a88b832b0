// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/BoundaryConditioning.h"

#include "Mesh/SliverThresholds.h"
#include "Remeshing/EdgeFlips.h"

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

// Edges shorter than this share of the mean boundary edge are collapsed. Isotropic remeshing uses the
// same share (Botsch, Kobbelt 2004); a larger one coarsens good boundaries.
constexpr double ShortShare = 0.8;
// Inner vertices nearer to the boundary than this share may become boundary vertices where they are,
// unless the curve is kept: a larger share would make the boundary jagged.
constexpr double VeryShortShare = 0.2;
// Cosine of 60 degrees: a collapse that tilts a face more could fold the surface.
constexpr double SmallestTilt = 0.5;
// The share by which a collapse may lower the smallest angle: a guard against rounding.
constexpr double Rounding = 1e-6;

class BoundaryConditioner
{
public:
  // `onCut` flags the vertices of the cut; `keepsCurve` says that the cut must keep its curve.
  BoundaryConditioner(EditableSurface& surface,
    int minimumVertices,
    std::vector<char> onCut,
    bool keepsCurve)
    : Surface(surface)
    , Mesh(surface.mesh())
    , MinimumVertices(minimumVertices)
    , OnCut(std::move(onCut))
    , KeepsCurve(keepsCurve)
  {
    double length = 0.0;
    for (const Halfedge h : this->Mesh.halfedges())
    {
      if (this->isCut(h))
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
    // A collapse may make a flip possible, and a flip a collapse.
    do
    {
      this->Changed = false;
      this->collapseShortEdges();
      this->flipAtBoundary();
    } while (this->Changed);
  }

private:
  // Whether it is a border half-edge that the cut has made.
  bool isCut(Halfedge border) const
  {
    return this->Mesh.is_border(border) && this->OnCut[this->Mesh.source(border)] &&
           this->OnCut[this->Mesh.target(border)];
  }

  bool isCut(Edge edge) const
  {
    const Halfedge h = this->Mesh.halfedge(edge);
    return this->isCut(h) || this->isCut(this->Mesh.opposite(h));
  }

  // Whether the cut meets an older boundary there.
  bool isEndOfCut(Vertex v) const
  {
    for (const Halfedge h : this->Mesh.halfedges_around_target(this->Mesh.halfedge(v)))
    {
      if (this->Mesh.is_border(this->Mesh.edge(h)) && !this->isCut(this->Mesh.edge(h)))
      {
        return true;
      }
    }
    return false;
  }

  void collapseShortEdges()
  {
    for (const Vertex v : this->Mesh.vertices())
    {
      if (this->OnCut[v])
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

  void flipAtBoundary()
  {
    std::vector<Edge> edges;
    for (const Edge edge : this->Mesh.edges())
    {
      const Halfedge h = this->Mesh.halfedge(edge);
      if (!this->Mesh.is_border(edge) &&
          (this->OnCut[this->Mesh.source(h)] || this->OnCut[this->Mesh.target(h)] ||
            this->OnCut[this->Mesh.target(this->Mesh.next(h))] ||
            this->OnCut[this->Mesh.target(this->Mesh.next(this->Mesh.opposite(h)))]))
      {
        edges.push_back(edge);
      }
    }
    this->Changed |= flipWhileImproving(this->Mesh, edges, [](Edge) { return true; });
  }

  // In single precision, so that lengths equal up to rounding tie and are sorted by index.
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
    const bool isCut = this->isCut(edge);
    if (isCut)
    {
      if (this->BoundaryVertices <= this->MinimumVertices)
      {
        return;
      }
    }
    else if (this->Mesh.is_border(edge))
    {
      return;
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
    // An inner vertex very near to the curve may become a boundary vertex where it is.
    if (!this->mayMove(h, isCut) &&
        (isCut || (!this->KeepsCurve && this->Surface.squaredLength(h) < this->VeryShort)))
    {
      h = this->Mesh.opposite(h);
    }
    if (!this->mayMove(h, isCut) || !CGAL::Euler::does_satisfy_link_condition(edge, this->Mesh))
    {
      return;
    }
    const Vertex stays = this->Mesh.target(h);
    const Point position = this->Mesh.point(stays);
    const Origin origin = this->Surface.origin(stays);
    const char onCut = this->OnCut[stays] || this->OnCut[this->Mesh.source(h)];
    this->BoundaryVertices -= isCut;
    const Vertex kept = CGAL::Euler::collapse_edge(edge, this->Mesh);
    this->OnCut[kept] = onCut;
    this->Mesh.point(kept) = position;
    this->Surface.origin(kept) = origin;
    this->enqueueAround(kept);
    this->Changed = true;
  }

  // Whether the source may move to the target.
  bool mayMove(Halfedge h, bool isCut) const
  {
    return !(isCut && this->isEndOfCut(this->Mesh.source(h))) && this->improves(h);
  }

  // Whether moving the source to the target tilts the faces around it little and leaves a smallest angle
  // that is no worse.
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
      if (!isTiltedLess(old, now, SmallestTilt))
      {
        return false;
      }
      after = std::min(after, smallestAngle(moved));
    }
    return after >= (1.0 - Rounding) * std::min(before, slivers::CutAngle);
  }

  EditableSurface& Surface;
  SurfaceMesh& Mesh;
  int MinimumVertices;
  std::vector<char> OnCut; // per vertex
  bool KeepsCurve;
  int BoundaryVertices = 0;
  double Short = 0.0; // squared length
  double VeryShort = 0.0;
  bool Changed = false;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> Queue;
};

} // namespace

void conditionBoundary(EditableSurface& surface, int minimumVertices)
{
  const SurfaceMesh& mesh = surface.mesh();
  std::vector<char> onBoundary(mesh.num_vertices(), 0);
  for (const Vertex v : mesh.vertices())
  {
    onBoundary[v] = mesh.is_border(v) ? 1 : 0;
  }
  BoundaryConditioner(surface, minimumVertices, std::move(onBoundary), false).run();
}

void conditionCut(EditableSurface& surface, const std::vector<char>& onCut, int minimumVertices)
{
  BoundaryConditioner(surface, minimumVertices, onCut, true).run();
}

} // namespace flattening
