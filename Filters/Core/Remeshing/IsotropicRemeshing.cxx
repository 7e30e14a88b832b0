// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/IsotropicRemeshing.h"

#include "Base/Memory.h"
#include "Mesh/SliverThresholds.h"
#include "Remeshing/BoundaryEars.h"
#include "Remeshing/EdgeQueue.h"
#include "Remeshing/MeshOnSurface.h"
#include "Remeshing/SelfIntersectionRemoval.h"
#include "Remeshing/SliverRemoval.h"

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
using Face = MeshOnSurface::Face;

// At least so many equilateral faces must fit on the surface: a guard against a length in wrong units.
constexpr double FewestFaces = 20.0;
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

// The largest number of points that remeshing makes: a convention, some sixteen gigabytes.
constexpr double MostPoints = 2e7;

// The memory that remeshing takes for each point that it makes, as measured at one and four million.
constexpr double BytesPerPoint = 800.0;

// Splitting long thin triangles makes more points than stay: at most so many times as many are let
// happen, but always a number that takes little memory. A guard.
constexpr double MostIntermediate = 10.0;
constexpr double AlwaysAllowed = 1e6;

// Half the equilateral faces that fit on the surface.
double expectedVertices(const TriangleMesh& mesh, double length)
{
  const double area = faceAreas(mesh.Vertices, mesh.Faces).sum();
  return 2.0 / std::sqrt(3.0) * area / length / length;
}

void requireSensibleLength(const TriangleMesh& mesh, double length)
{
  std::ostringstream message; // lengths of any order of magnitude
  if (!(length > 0.0) || !std::isfinite(length))
  {
    message << "the target edge length is " << formatted(length)
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
  const double points = expectedVertices(mesh, length);
  message << "the target edge length " << length << " would make about " << points << " points";
  if (!(points <= MostPoints))
  {
    message << ", more than " << MostPoints << ": set it above "
            << std::sqrt(2.0 / std::sqrt(3.0) * area / MostPoints);
    throw InvalidInput(message.str());
  }
  message << "; this";
  requireMemory(message.str(), BytesPerPoint * points, "set a greater length");
}

bool staysSound(const LocalChange& change)
{
  const double alignmentAfter = smallestAlignment(change.After);
  const double sineAfter = smallestSine(change.After);
  return (alignmentAfter >= LeastAlignment || alignmentAfter >= smallestAlignment(change.Before)) &&
         (sineAfter >= slivers::RemeshedSine || sineAfter >= smallestSine(change.Before));
}

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

class IsotropicRemesher
{
public:
  /// @param expectedVertices that the area of the surface lets one expect
  IsotropicRemesher(MeshOnSurface& surface, double length, double expectedVertices)
    : Surface(surface)
    , Length(length)
    , MostVertices(static_cast<std::size_t>(
        std::clamp(MostIntermediate * (expectedVertices + surface.mesh().number_of_vertices()),
          AlwaysAllowed,
          MostPoints)))
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

  // Whether a flip keeps the surface nearly as it is.
  MeshOnSurface::Guard keepsSurface() const
  {
    return [height = GreatestFlipHeight * this->Length](const LocalChange& change)
    { return flipHeight(change) <= height && staysSound(change); };
  }

private:
  template <typename Order, typename IsWanted, typename Change>
  void changeEdges(IsWanted&& isWanted, Change&& change, const ProgressCallback& progress);
  void splitLongEdges(const ProgressCallback& progress);
  void collapseShortEdges(const ProgressCallback& progress);
  void relax(const ProgressCallback& progress);

  MeshOnSurface& Surface;
  double Length;
  std::size_t MostVertices;
};

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

void IsotropicRemesher::splitLongEdges(const ProgressCallback& progress)
{
  const auto split = [this](Edge e)
  {
    if (this->Surface.mesh().number_of_vertices() > this->MostVertices)
    {
      std::ostringstream message;
      message << "the target edge length " << this->Length << " makes more than " << this->MostVertices
              << " points on the way, as the surface has long thin triangles: set a greater length";
      throw InvalidInput(message.str());
    }
    return this->Surface.split(e, staysSound);
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

} // namespace

DerivedMesh remeshIsotropically(const TriangleMesh& mesh,
  double targetEdgeLength,
  int iterations,
  const ProgressCallback& progress,
  TrackedIntersections* intersections)
{
  requireSensibleLength(mesh, targetEdgeLength);
  report(progress, 0.0, "remeshing");
  MeshOnSurface surface(mesh);
  IsotropicRemesher remesher(surface, targetEdgeLength, expectedVertices(mesh, targetEdgeLength));
  for (int i = 0; i < iterations; ++i)
  {
    remesher.iterate(subrange(progress, 0.8 * i / iterations, 0.8 * (i + 1) / iterations));
  }
  remesher.flipToDelaunay(subrange(progress, 0.8, 0.85));
  removeSlivers(surface, slivers::RemeshedAngle, subrange(progress, 0.85, 0.9));
  openEars(surface, remesher.keepsSurface(), staysSound);
  removeSelfIntersections(surface, subrange(progress, 0.9, 0.95), intersections);
  return surface.derived(subrange(progress, 0.95, 1.0));
}

} // namespace flattening
