// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/IsotropicRemesher.h"

#include "Base/Errors.h"
#include "Mesh/SliverThresholds.h"
#include "Remeshing/EdgeQueue.h"

#include <Eigen/Geometry>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

using Vertex = MeshOnSurface::Vertex;
using Halfedge = MeshOnSurface::Halfedge;
using Edge = MeshOnSurface::Edge;

// An abort is noticed after so many changes.
constexpr int ReportInterval = 1 << 14;

// Botsch, Kobbelt 2004: edges longer or shorter than these multiples of the target length are split or
// collapsed. Nearer to 1, splits and collapses would undo each other.
constexpr double LongEdge = 4.0 / 3.0;
constexpr double ShortEdge = 4.0 / 5.0;

// Lengths that differ by less than this part of the target length may come in any order: a convention.
constexpr double BandsPerLength = 16.0;

// Cosine of 60 degrees: no operation may leave a face steeper against the old surface, unless it
// replaces a steeper one. A smaller cosine lets faces fold, a larger one keeps edges short where the
// surface bends.
constexpr double LeastAlignment = 0.5;

// Vertices that would move by less than this share of the target length have settled. A convention: a
// smaller share costs time, a larger one leaves the triangles less regular.
constexpr double SmallestStep = 0.02;

// The largest height, as a share of the target length, by which flipping an edge may change the surface.
// A convention: a larger share wears creases off.
constexpr double GreatestFlipHeight = 0.15;

// The length of the longest edge at the triangles' first corners.
double longestSpoke(const LocalChange::Triangles& triangles)
{
  double longest = 0.0;
  for (const CornerTriangle& t : triangles)
  {
    longest = std::max({ longest,
      (*t[1].Position - *t[0].Position).squaredNorm(),
      (*t[2].Position - *t[0].Position).squaredNorm() });
  }
  return std::sqrt(longest);
}

// Whether the angles at the two apexes over the same base, both in [0, pi], sum to more than pi. The sum
// must exceed pi by more than rounding, so that no edge is flipped to and fro.
bool sumExceedsPi(const Eigen::Vector3d& apex1,
  const Eigen::Vector3d& apex2,
  const Eigen::Vector3d& base1,
  const Eigen::Vector3d& base2)
{
  const auto sineAndCosine = [&base1, &base2](const Eigen::Vector3d& apex)
  {
    const Eigen::Vector3d u = base1 - apex;
    const Eigen::Vector3d v = base2 - apex;
    return std::make_pair(u.cross(v).norm(), u.dot(v));
  };
  const auto [sine1, cosine1] = sineAndCosine(apex1);
  const auto [sine2, cosine2] = sineAndCosine(apex2);
  const double size = (std::abs(sine1) + std::abs(cosine1)) * (std::abs(sine2) + std::abs(cosine2));
  return sine1 * cosine2 + cosine1 * sine2 < -1e-9 * size;
}

// Whether a flip makes the sum of the two angles opposite to the edge smaller: the Delaunay property.
bool becomesDelaunay(const LocalChange& flip)
{
  const CornerTriangle& left = flip.Before[0];
  const CornerTriangle& right = flip.Before[1];
  return sumExceedsPi(*left[2].Position, *right[2].Position, *left[0].Position, *left[1].Position);
}

// The distance between the two diagonals of a flip, input units: how much it changes the surface.
double flipHeight(const LocalChange& flip)
{
  const Eigen::Vector3d& from = *flip.Before[0][0].Position;
  const Eigen::Vector3d& left = *flip.Before[0][2].Position;
  const Eigen::Vector3d old = *flip.Before[0][1].Position - from;
  const Eigen::Vector3d now = *flip.Before[1][2].Position - left;
  const Eigen::Vector3d across = old.cross(now);
  const double length = across.norm();
  return length > 0.0 ? std::abs(across.dot(left - from)) / length : 0.0;
}

} // namespace

bool IsotropicRemesher::staysSound(const LocalChange& change)
{
  const double alignmentAfter = smallestAlignment(change.After);
  const double sineAfter = smallestSine(change.After);
  return (alignmentAfter >= LeastAlignment || alignmentAfter >= smallestAlignment(change.Before)) &&
         (sineAfter >= slivers::RemeshedSine || sineAfter >= smallestSine(change.Before));
}

void IsotropicRemesher::iterate(const ProgressCallback& progress)
{
  this->collapseShortEdges(subrange(progress, 0.0, 0.4));
  this->splitLongEdges(subrange(progress, 0.4, 0.6));
  this->flipToDelaunay(subrange(progress, 0.6, 0.75));
  this->relax(subrange(progress, 0.75, 1.0));
}

MeshOnSurface::Guard IsotropicRemesher::keepsSurface() const
{
  return [height = GreatestFlipHeight * this->Length](const LocalChange& change)
  { return flipHeight(change) <= height && staysSound(change); };
}

// Calls `change` for every edge whose length is wanted, in the order of the queue. It returns a vertex
// whose edges may have become wanted, or no vertex.
template <typename Order, typename IsWanted, typename Change>
void IsotropicRemesher::changeEdges(IsWanted&& isWanted,
  Change&& change,
  const ProgressCallback& progress)
{
  const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
  EdgeQueue<Order> queue(this->Length / BandsPerLength);
  const auto enqueue = [this, &mesh, &queue, &isWanted](Halfedge h)
  {
    if (const double length = this->Surface.length(h); isWanted(length))
    {
      queue.push(mesh.edge(h), length);
    }
  };
  for (const Edge e : mesh.edges())
  {
    enqueue(mesh.halfedge(e));
  }
  for (int done = 0; !queue.empty(); ++done)
  {
    if (done % ReportInterval == 0)
    {
      report(progress, static_cast<double>(done) / (done + queue.size()), "remeshing");
    }
    const auto next = queue.pop();
    // The edge may be gone, or may have another length by now.
    if (mesh.is_removed(next.Edge) || this->Surface.length(mesh.halfedge(next.Edge)) != next.Length)
    {
      continue;
    }
    if (const Vertex changed = change(next.Edge); changed != MeshOnSurface::Mesh::null_vertex())
    {
      for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(changed)))
      {
        enqueue(h);
      }
    }
  }
}

// Whether one of the faces beside an edge has an edge that comes before it in the queue, and thus was
// not split, as both its ends are kept or it is beside such an edge. Splitting the other edges of a flat
// face would never make them short.
bool IsotropicRemesher::isBesideLongerEdge(Edge edge) const
{
  const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
  const double limit = this->Surface.length(mesh.halfedge(edge)) + this->Length / BandsPerLength;
  for (const Halfedge h : { mesh.halfedge(edge), mesh.opposite(mesh.halfedge(edge)) })
  {
    if (!mesh.is_border(h) &&
        (this->Surface.length(mesh.next(h)) > limit || this->Surface.length(mesh.prev(h)) > limit))
    {
      return true;
    }
  }
  return false;
}

void IsotropicRemesher::splitLongEdges(const ProgressCallback& progress)
{
  const auto split = [this](Edge e)
  {
    const auto vertices = static_cast<double>(this->Surface.mesh().number_of_vertices());
    if (vertices > this->Limit.Share * static_cast<double>(this->Limit.Most))
    {
      std::ostringstream message;
      message << "the target edge length " << this->Length << " makes more than " << this->Limit.Most
              << " points on the way, as the surface has long thin triangles: set a greater length";
      throw InvalidInput(message.str());
    }
    return this->isBesideLongerEdge(e) ? MeshOnSurface::Mesh::null_vertex()
                                       : this->Surface.split(e, staysSound);
  };
  this->changeEdges<std::greater<>>(
    [bound = LongEdge * this->Length](double length) { return length > bound; }, split, progress);
}

void IsotropicRemesher::collapseShortEdges(const ProgressCallback& progress)
{
  const auto makesNoLongEdge = [limit = LongEdge * this->Length](const LocalChange& change)
  {
    const double after = longestSpoke(change.After);
    return (after <= limit || after <= longestSpoke(change.Before)) && staysSound(change);
  };
  const auto collapse = [this, &makesNoLongEdge](Edge e)
  {
    const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
    const Vertex source = mesh.source(mesh.halfedge(e));
    const Vertex target = mesh.target(mesh.halfedge(e));
    if (!this->Surface.collapse(e, makesNoLongEdge))
    {
      return MeshOnSurface::Mesh::null_vertex();
    }
    return mesh.is_removed(source) ? target : source;
  };
  this->changeEdges<std::less<>>(
    [bound = ShortEdge * this->Length](double length) { return length < bound; }, collapse, progress);
}

void IsotropicRemesher::flipToDelaunay(const ProgressCallback& progress)
{
  const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
  const auto improves = [keepsSurface = this->keepsSurface()](const LocalChange& change)
  { return becomesDelaunay(change) && keepsSurface(change); };
  constexpr int Rounds = 8; // a guard: most edges settle in two or three rounds
  std::vector<char> settled(mesh.num_edges(), 0);
  bool flipped = true;
  for (int round = 0; flipped && round < Rounds; ++round)
  {
    report(progress, static_cast<double>(round) / Rounds, "remeshing");
    flipped = false;
    for (const Edge e : mesh.edges())
    {
      if (settled[e.idx()])
      {
        continue;
      }
      settled[e.idx()] = 1;
      if (this->Surface.flip(e, improves))
      {
        flipped = true;
        const Halfedge h = mesh.halfedge(e);
        for (const Halfedge side : { h, mesh.opposite(h) })
        {
          settled[mesh.edge(mesh.next(side)).idx()] = settled[mesh.edge(mesh.prev(side)).idx()] = 0;
        }
      }
    }
  }
}

// Moves every interior vertex towards the mean of its neighbours, along the surface.
void IsotropicRemesher::relax(const ProgressCallback& progress)
{
  report(progress, 0.0, "remeshing");
  const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
  const SurfacePoint none{ -1, Eigen::Vector3d::Zero(), { 0.0, 0.0, 0.0 } };
  std::vector<SurfacePoint> targets(mesh.num_vertices(), none);
  tbb::parallel_for(std::size_t(0),
    targets.size(),
    [this, &mesh, &targets](std::size_t i)
    {
      const Vertex v(static_cast<unsigned>(i));
      if (mesh.is_removed(v) || this->Surface.onBoundary(v))
      {
        return;
      }
      const Corner here = this->Surface.corner(v);
      const Eigen::Vector3d step = this->Surface.meanOfNeighbours(v) - *here.Position;
      const Eigen::Vector3d tangential = step - here.Normal->dot(step) * *here.Normal;
      if (tangential.norm() < SmallestStep * this->Length)
      {
        return;
      }
      targets[i] =
        this->Surface.walk().closest(*here.Position + tangential, this->Surface.place(v).Face);
    });
  report(progress, 0.5, "remeshing");
  for (const Vertex v : mesh.vertices())
  {
    if (const SurfacePoint& to = targets[v.idx()]; to.Face >= 0)
    {
      this->Surface.move(v, to, to.Position, staysSound);
    }
  }
}

} // namespace flattening
