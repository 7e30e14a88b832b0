// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/MeshOnSurface.h"

#include "Base/Errors.h"
#include "Mesh/EditableSurface.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <Eigen/Geometry>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// How far a vertex may lie off the chord that replaces it on a boundary, as a share of the chord: a
// convention. A larger share straightens the boundary, a smaller one keeps it from being coarsened.
constexpr double BoundarySagitta = 0.05;
// An abort is noticed after so many faces.
constexpr int FacesPerReport = 32768;
constexpr const char* CarryingStage = "carrying attributes over";

} // namespace

MeshOnSurface::MeshOnSurface(const TriangleMesh& old)
  : MeshOnSurface(std::make_shared<ClosestPointWalk>(old))
{
}

MeshOnSurface::MeshOnSurface(std::shared_ptr<const ClosestPointWalk> walk)
  : MeshOnSurface(walk, placedOnItself(*walk))
{
}

MeshOnSurface::MeshOnSurface(std::shared_ptr<const ClosestPointWalk> walk,
  const PlacedMesh& present,
  const std::vector<char>& kept)
  : Walk(std::move(walk))
  , Old(this->Walk->mesh())
  , Surface(toSurfaceMesh<Eigen::Vector3d>(present.Mesh))
{
  this->Place = this->Surface.add_property_map<Vertex, SurfacePoint>("v:place").first;
  this->Normal = this->Surface.add_property_map<Vertex, Eigen::Vector3d>("v:old normal").first;
  this->Boundary = this->Surface.add_property_map<Vertex, char>("v:boundary", 0).first;
  this->Kept = this->Surface.add_property_map<Vertex, char>("v:kept", 0).first;
  tbb::parallel_for(0,
    present.Mesh.vertexCount(),
    [&](int i)
    {
      const Vertex v(static_cast<unsigned>(i));
      this->Kept[v] = kept.empty() ? 0 : kept[i];
      this->set(v, this->Surface.point(v), present.Places[i], this->Walk->normal(present.Places[i]));
      // toSurfaceMesh gives a vertex of the border the half-edge of the border that ends there.
      this->Boundary[v] = static_cast<char>(this->Surface.is_border(this->Surface.halfedge(v)));
    });
}

Corner MeshOnSurface::corner(Vertex v) const
{
  return { static_cast<int>(v.idx()), &this->Surface.point(v), &this->Normal[v] };
}

CornerTriangle MeshOnSurface::triangle(Face f) const
{
  const Halfedge h = this->Surface.halfedge(f);
  return { this->corner(this->Surface.source(h)),
    this->corner(this->Surface.target(h)),
    this->corner(this->Surface.target(this->Surface.next(h))) };
}

double MeshOnSurface::length(Halfedge h) const
{
  return (this->Surface.point(this->Surface.target(h)) - this->Surface.point(this->Surface.source(h)))
    .norm();
}

Eigen::Vector3d MeshOnSurface::meanOfNeighbours(Vertex v) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int neighbours = 0;
  for (const Vertex w : this->Surface.vertices_around_target(this->Surface.halfedge(v)))
  {
    sum += this->Surface.point(w);
    ++neighbours;
  }
  return sum / neighbours;
}

// Adds the triangles around v with v moved, except those that also have the other vertex.
void MeshOnSurface::gatherStar(Vertex v, Vertex except, const Corner& to, LocalChange& change) const
{
  const Corner here = this->corner(v);
  for (const Halfedge h : this->Surface.halfedges_around_target(this->Surface.halfedge(v)))
  {
    const Vertex next = this->Surface.target(this->Surface.next(h));
    const Vertex before = this->Surface.source(h);
    if (this->Surface.is_border(h) || next == except || before == except)
    {
      continue;
    }
    change.Removed.push_back(static_cast<int>(this->Surface.face(h).idx()));
    change.Before.push_back({ here, this->corner(next), this->corner(before) });
    change.After.push_back({ to, change.Before.back()[1], change.Before.back()[2] });
  }
}

LocalChange MeshOnSurface::changeByCollapsing(Halfedge h, const Corner& to) const
{
  const Vertex a = this->Surface.source(h);
  const Vertex b = this->Surface.target(h);
  LocalChange change;
  this->gatherStar(a, b, to, change);
  this->gatherStar(b, a, to, change);
  for (const Halfedge side : { h, this->Surface.opposite(h) })
  {
    if (!this->Surface.is_border(side))
    {
      change.Removed.push_back(static_cast<int>(this->Surface.face(side).idx()));
      change.Before.push_back(this->triangle(this->Surface.face(side)));
    }
  }
  return change;
}

MeshOnSurface::Vertex MeshOnSurface::split(Edge edge, const Guard& guard)
{
  const Halfedge h = this->Surface.halfedge(edge);
  const Halfedge opposite = this->Surface.opposite(h);
  const Vertex source = this->Surface.source(h);
  if (this->bothKept(source, this->Surface.target(h)))
  {
    return Mesh::null_vertex();
  }
  const bool border = this->Surface.is_border(h) || this->Surface.is_border(opposite);
  const Eigen::Vector3d middle =
    0.5 * (this->Surface.point(source) + this->Surface.point(this->Surface.target(h)));
  const double length = this->length(h);
  const SurfacePoint place = this->Walk->closest(middle, this->Place[source].Face);

  const Halfedge first = CGAL::Euler::split_edge(h, this->Surface); // source -> new vertex
  const Vertex added = this->Surface.target(first);
  if (!this->Surface.is_border(first))
  {
    CGAL::Euler::split_face(first, this->Surface.next(h), this->Surface);
  }
  if (!this->Surface.is_border(opposite))
  {
    CGAL::Euler::split_face(opposite, this->Surface.next(this->Surface.opposite(first)), this->Surface);
  }
  this->Boundary[added] = static_cast<char>(border);
  this->Kept[added] = 0;
  this->set(added, middle, place, this->Walk->normal(place));
  // A middle that moved farther could make an edge as long as this one was, and splitting need not end.
  constexpr double Near = 0.1;
  if (!border && (place.Position - middle).norm() <= Near * length)
  {
    this->move(added, place, place.Position, guard);
  }
  return added;
}

bool MeshOnSurface::flip(Edge edge, const Guard& guard)
{
  if (this->Surface.is_border(edge))
  {
    return false;
  }
  const Halfedge h = this->Surface.halfedge(edge);
  const Halfedge back = this->Surface.opposite(h);
  const Vertex left = this->Surface.target(this->Surface.next(h));
  const Vertex right = this->Surface.target(this->Surface.next(back));
  if (left == right || this->bothKept(left, right) ||
      this->bothKept(this->Surface.source(h), this->Surface.target(h)))
  {
    return false;
  }
  const Corner a = this->corner(this->Surface.source(h));
  const Corner b = this->corner(this->Surface.target(h));
  const Corner c = this->corner(left);
  const Corner d = this->corner(right);
  LocalChange change;
  change.Removed = { static_cast<int>(this->Surface.face(h).idx()),
    static_cast<int>(this->Surface.face(back).idx()) };
  change.Before = { CornerTriangle{ a, b, c }, CornerTriangle{ b, a, d } };
  change.After = { CornerTriangle{ a, d, c }, CornerTriangle{ d, b, c } };
  if (!guard(change) || this->Surface.halfedge(left, right) != Mesh::null_halfedge())
  {
    return false;
  }
  CGAL::Euler::flip_edge(h, this->Surface);
  return true;
}

bool MeshOnSurface::move(Vertex vertex,
  const SurfacePoint& to,
  const Eigen::Vector3d& position,
  const Guard& guard)
{
  if (this->onBoundary(vertex) || this->Kept[vertex] != 0)
  {
    return false;
  }
  const Eigen::Vector3d normal = this->Walk->normal(to);
  LocalChange change;
  this->gatherStar(
    vertex, Mesh::null_vertex(), { static_cast<int>(vertex.idx()), &position, &normal }, change);
  if (!guard(change))
  {
    return false;
  }
  this->set(vertex, position, to, normal);
  return true;
}

// Whether the boundary may lose the vertex that a border half-edge ends in.
bool MeshOnSurface::straightAround(Halfedge border) const
{
  const Eigen::Vector3d& from = this->Surface.point(this->Surface.source(border));
  const Eigen::Vector3d& at = this->Surface.point(this->Surface.target(border));
  const Eigen::Vector3d& to = this->Surface.point(this->Surface.target(this->Surface.next(border)));
  const Eigen::Vector3d chord = to - from;
  const bool between = chord.dot(at - from) > 0.0 && chord.dot(to - at) > 0.0;
  return between && chord.cross(at - from).norm() <= BoundarySagitta * chord.squaredNorm();
}

// Whether removing the source of a half-edge whose target is kept would join the target to another
// vertex that is kept.
bool MeshOnSurface::makesKeptEdge(Halfedge h) const
{
  const Vertex left = this->Surface.target(this->Surface.next(h));
  const Vertex right = this->Surface.target(this->Surface.next(this->Surface.opposite(h)));
  for (const Vertex v : this->Surface.vertices_around_target(this->Surface.opposite(h)))
  {
    if (this->Kept[v] != 0 && v != this->Surface.target(h) && v != left && v != right)
    {
      return true;
    }
  }
  return false;
}

bool MeshOnSurface::collapse(Edge edge, const Guard& guard)
{
  const Halfedge h = this->Surface.halfedge(edge);
  const Halfedge back = this->Surface.opposite(h);
  const Vertex a = this->Surface.source(h);
  const Vertex b = this->Surface.target(h);
  const Halfedge toKept = this->Kept[a] != 0 ? back : h; // if one of the two is kept
  const bool oneIsKept = this->Kept[this->Surface.target(toKept)] != 0;
  if (this->bothKept(a, b) ||
      (oneIsKept && (this->Surface.is_border(edge) || this->makesKeptEdge(toKept))))
  {
    return false;
  }
  const bool aStays = this->onBoundary(a) || this->Kept[a] != 0;
  const bool bStays = this->onBoundary(b) || this->Kept[b] != 0;
  boost::container::small_vector<Target, 3> targets;
  const Target atA{ this->Surface.point(a), this->Place[a] };
  const Target atB{ this->Surface.point(b), this->Place[b] };
  if (!aStays && !bStays)
  {
    const SurfacePoint middle =
      this->Walk->closest(0.5 * (atA.Position + atB.Position), this->Place[a].Face);
    targets = { Target{ middle.Position, middle }, atA, atB };
  }
  else if (this->Surface.is_border(edge))
  {
    const Halfedge border = this->Surface.is_border(h) ? h : back; // from and to along the boundary
    const Halfedge previous = this->Surface.prev(border);
    const bool forwards = border == h;
    if (this->straightAround(border))
    {
      targets.push_back(forwards ? atA : atB);
    }
    if (this->straightAround(previous))
    {
      targets.push_back(forwards ? atB : atA);
    }
  }
  else if (aStays != bStays)
  {
    targets.push_back(aStays ? atA : atB);
  }

  Eigen::Vector3d normal;
  const auto admitted = std::find_if(targets.begin(),
    targets.end(),
    [this, h, a, &guard, &normal](const Target& target)
    {
      normal = this->Walk->normal(target.Place);
      return guard(
        this->changeByCollapsing(h, { static_cast<int>(a.idx()), &target.Position, &normal }));
    });
  if (admitted == targets.end() || !CGAL::Euler::does_satisfy_link_condition(edge, this->Surface))
  {
    return false;
  }
  const bool border = this->onBoundary(a) || this->onBoundary(b);
  // CGAL removes the source of the half-edge between two faces.
  const Vertex kept =
    CGAL::Euler::collapse_edge(oneIsKept ? this->Surface.edge(toKept) : edge, this->Surface);
  this->Boundary[kept] = static_cast<char>(border);
  this->set(kept, admitted->Position, admitted->Place, normal);
  return true;
}

PlacedMesh MeshOnSurface::placed() const
{
  PlacedMesh placed{ toTriangleMesh(this->Surface), {} };
  placed.Places.reserve(this->Surface.number_of_vertices());
  for (const Vertex v : this->Surface.vertices())
  {
    placed.Places.push_back(this->Place[v]);
  }
  return placed;
}

// A vertex that lies beside the old one that is nearest to it is not that one, which a second corner
// without weight tells.
Origin MeshOnSurface::originOfVertex(Vertex v) const
{
  const SurfacePoint& place = this->Place[v];
  Origin origin = originOf(this->Old.Faces, place.Face, place.Weights);
  if (origin.size() == 1)
  {
    const int nearest = origin.front().first;
    const Eigen::RowVector3d old = this->Old.Vertices.row(nearest);
    if (this->Surface.point(v) != old.transpose())
    {
      const auto corners = this->Old.Faces.row(place.Face);
      origin.emplace_back(corners[0] == nearest ? corners[1] : corners[0], 0.0);
    }
  }
  return origin;
}

// Whether the face is the old one with its number, as most are where only a few were changed.
bool MeshOnSurface::isOld(Face f) const
{
  const auto isCorner = [this, f](Vertex v)
  {
    return (this->Old.Faces.row(f.idx()).array() == static_cast<int>(v.idx())).any() &&
           this->Surface.point(v) == this->Old.Vertices.row(v.idx()).transpose();
  };
  const auto corners = this->Surface.vertices_around_face(this->Surface.halfedge(f));
  return static_cast<int>(f.idx()) < this->Old.faceCount() &&
         std::all_of(corners.begin(), corners.end(), isCorner);
}

int MeshOnSurface::originOfFace(Face f) const
{
  if (this->isOld(f))
  {
    return static_cast<int>(f.idx());
  }
  const Halfedge h = this->Surface.halfedge(f);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Vertex v : this->Surface.vertices_around_face(h))
  {
    sum += this->Surface.point(v);
  }
  return this->Walk->closest(sum / 3.0, this->Place[this->Surface.target(h)].Face).Face;
}

DerivedMesh MeshOnSurface::derived(const ProgressCallback& progress) const
{
  report(progress, 0.0, CarryingStage);
  DerivedMesh result;
  result.Mesh = toTriangleMesh(this->Surface);
  result.Vertices = originMatrix(this->Surface.vertices(),
    this->Old.vertexCount(),
    [this](Vertex v) { return this->originOfVertex(v); });

  const std::vector<Face> faces(this->Surface.faces().begin(), this->Surface.faces().end());
  const auto count = static_cast<int>(faces.size());
  result.Faces.resize(count);
  for (int begin = 0; begin < count; begin += FacesPerReport)
  {
    report(progress, 0.2 + 0.8 * begin / count, CarryingStage);
    tbb::parallel_for(begin,
      std::min(begin + FacesPerReport, count),
      [this, &result, &faces](int f) { result.Faces[f] = this->originOfFace(faces[f]); });
  }
  return result;
}

} // namespace flattening
