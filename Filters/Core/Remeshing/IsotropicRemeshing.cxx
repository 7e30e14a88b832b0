// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/IsotropicRemeshing.h"

#include "Remeshing/MeshOnSurface.h"
#include "Remeshing/SelfIntersectionRemoval.h"
#include "Remeshing/SliverRemoval.h"

#include <Eigen/Geometry>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <queue>
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
using Face = MeshOnSurface::Face;

constexpr double FewestFaces = 20.0;
constexpr int ReportInterval = 1 << 14;

// Botsch, Kobbelt 2004: edges outside of these multiples of the target length are split or collapsed.
constexpr double LongEdge = 4.0 / 3.0;
constexpr double ShortEdge = 4.0 / 5.0;

// No operation may leave a triangle steeper against the old surface than 60 degrees, or with an angle
// below 15 degrees, unless it replaces a worse one.
constexpr double LeastAlignment = 0.5;
constexpr double LeastSine = 0.26;

// Share of the target length; vertices that would move less have settled.
constexpr double SmallestStep = 0.02;

// Degrees; what is left below is worth a search of its own.
constexpr double NarrowAngle = 15.0;

// Height, as a share of the target length, by which flipping an edge may change the surface.
constexpr double GreatestFlipHeight = 0.15;

void requireSensibleLength(const TriangleMesh& mesh, double length)
{
  std::ostringstream message; // lengths of any order of magnitude
  if (!(length > 0.0) || !std::isfinite(length))
  {
    message << "the target edge length is " << length
            << ": set a positive length in the units of the surface";
    throw InvalidInput(message.str());
  }
  const double area = faceAreas(mesh.Vertices, mesh.Faces).sum();
  const double longest = std::sqrt(area / FewestFaces * 4.0 / std::sqrt(3.0)); // of equilateral faces
  if (length > longest)
  {
    message << "the target edge length " << length << " would leave fewer than " << FewestFaces
            << " faces: set it below " << longest;
    throw InvalidInput(message.str());
  }
}

bool staysSound(const LocalChange& change)
{
  const double alignmentAfter = smallestAlignment(change.After);
  const double sineAfter = smallestSine(change.After);
  return (alignmentAfter >= LeastAlignment || alignmentAfter >= smallestAlignment(change.Before)) &&
         (sineAfter >= LeastSine || sineAfter >= smallestSine(change.Before));
}

// Of the edges at the triangles' first corners.
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

class IsotropicRemesher
{
public:
  IsotropicRemesher(MeshOnSurface& surface, double length)
    : Surface(surface)
    , Length(length)
  {
  }

  void iterate(const ProgressCallback& progress)
  {
    this->collapseShortEdges(subrange(progress, 0.0, 0.4));
    this->splitLongEdges(subrange(progress, 0.4, 0.6));
    this->flipToDelaunay(subrange(progress, 0.6, 0.75));
    this->relax(subrange(progress, 0.75, 1.0));
  }

  void flipToDelaunay(const ProgressCallback& progress);

private:
  // Edges of nearly the same length are taken in the order of memory, not all over the surface.
  struct QueuedEdge
  {
    double Length;
    int Band;
    Edge Descriptor;

    bool operator<(const QueuedEdge& other) const
    {
      return std::make_pair(this->Band, other.Descriptor) < std::make_pair(other.Band, this->Descriptor);
    }
    bool operator>(const QueuedEdge& other) const
    {
      return std::make_pair(this->Band, this->Descriptor) > std::make_pair(other.Band, other.Descriptor);
    }
  };

  QueuedEdge queued(double length, Edge e) const
  {
    constexpr double BandsPerLength = 16.0;
    constexpr double LastBand = 1e6;
    return { length, static_cast<int>(std::min(BandsPerLength * length / this->Length, LastBand)), e };
  }

  void splitLongEdges(const ProgressCallback& progress);
  void collapseShortEdges(const ProgressCallback& progress);
  void relax(const ProgressCallback& progress);

  double lengthOf(Edge e) const { return this->Surface.length(this->Surface.mesh().halfedge(e)); }

  // The queue may hold edges that are gone, or are not as long any more.
  bool isCurrent(const QueuedEdge& queued) const
  {
    return !this->Surface.mesh().is_removed(queued.Descriptor) &&
           this->lengthOf(queued.Descriptor) == queued.Length;
  }

  MeshOnSurface& Surface;
  double Length;
};

void IsotropicRemesher::splitLongEdges(const ProgressCallback& progress)
{
  const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
  std::priority_queue<QueuedEdge> queue; // longest first
  const double bound = LongEdge * this->Length;
  for (const Edge e : mesh.edges())
  {
    if (const double length = this->lengthOf(e); length > bound)
    {
      queue.push(this->queued(length, e));
    }
  }
  for (int done = 0; !queue.empty(); ++done)
  {
    if (done % ReportInterval == 0)
    {
      report(progress, static_cast<double>(done) / (done + queue.size()), "remeshing");
    }
    const QueuedEdge longest = queue.top();
    queue.pop();
    if (!this->isCurrent(longest))
    {
      continue;
    }
    const Vertex middle = this->Surface.split(longest.Descriptor, staysSound);
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(middle)))
    {
      if (const double length = this->Surface.length(h); length > bound)
      {
        queue.push(this->queued(length, mesh.edge(h)));
      }
    }
  }
}

void IsotropicRemesher::collapseShortEdges(const ProgressCallback& progress)
{
  const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
  std::priority_queue<QueuedEdge, std::vector<QueuedEdge>, std::greater<>> queue; // shortest first
  const double bound = ShortEdge * this->Length;
  for (const Edge e : mesh.edges())
  {
    if (const double length = this->lengthOf(e); length < bound)
    {
      queue.push(this->queued(length, e));
    }
  }
  const auto makesNoLongEdge = [limit = LongEdge * this->Length](const LocalChange& change)
  {
    const double after = longestSpoke(change.After);
    return (after <= limit || after <= longestSpoke(change.Before)) && staysSound(change);
  };
  for (int done = 0; !queue.empty(); ++done)
  {
    if (done % ReportInterval == 0)
    {
      report(progress, static_cast<double>(done) / (done + queue.size()), "remeshing");
    }
    const QueuedEdge shortest = queue.top();
    queue.pop();
    if (!this->isCurrent(shortest))
    {
      continue;
    }
    const Vertex source = mesh.source(mesh.halfedge(shortest.Descriptor));
    const Vertex target = mesh.target(mesh.halfedge(shortest.Descriptor));
    if (!this->Surface.collapse(shortest.Descriptor, makesNoLongEdge))
    {
      continue;
    }
    const Vertex kept = mesh.is_removed(source) ? target : source;
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(kept)))
    {
      if (const double length = this->Surface.length(h); length < bound)
      {
        queue.push(this->queued(length, mesh.edge(h)));
      }
    }
  }
}

void IsotropicRemesher::flipToDelaunay(const ProgressCallback& progress)
{
  const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
  const auto improves = [height = GreatestFlipHeight * this->Length](const LocalChange& change)
  { return opensAngles(change) && flipHeight(change) <= height && staysSound(change); };
  constexpr int Rounds = 8; // most edges settle in two or three
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

// Every interior vertex goes to the mean of its neighbours, along the surface.
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
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      int neighbours = 0;
      for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      {
        sum += mesh.point(mesh.source(h));
        ++neighbours;
      }
      const Corner here = this->Surface.corner(v);
      const Eigen::Vector3d step = sum / neighbours - *here.Position;
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

} // namespace

DerivedMesh remeshIsotropically(const TriangleMesh& mesh,
  double targetEdgeLength,
  int iterations,
  const ProgressCallback& progress)
{
  requireSensibleLength(mesh, targetEdgeLength);
  report(progress, 0.0, "remeshing");
  MeshOnSurface surface(mesh);
  IsotropicRemesher remesher(surface, targetEdgeLength);
  for (int i = 0; i < iterations; ++i)
  {
    remesher.iterate(subrange(progress, 0.8 * i / iterations, 0.8 * (i + 1) / iterations));
  }
  remesher.flipToDelaunay(subrange(progress, 0.8, 0.9));
  removeSlivers(surface, NarrowAngle, subrange(progress, 0.85, 0.9));
  removeSelfIntersections(surface, subrange(progress, 0.9, 0.95));
  return surface.derived(subrange(progress, 0.95, 1.0));
}

} // namespace flattening
