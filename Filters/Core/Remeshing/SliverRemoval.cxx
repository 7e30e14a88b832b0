// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/SliverRemoval.h"

#include "Mesh/MeshMeasures.h"
#include "Mesh/SliverThresholds.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

using Vertex = MeshOnSurface::Vertex;
using Edge = MeshOnSurface::Edge;
using Halfedge = MeshOnSurface::Halfedge;
using Face = MeshOnSurface::Face;

// A guard: the rounds usually end because nothing changes any more.
constexpr int SliverRounds = 10;
// An abort is noticed after so many faces, whose vertices may have thousands of neighbours.
constexpr std::size_t FacesBetweenReports = 64;
// The factor by which a change must enlarge the sine of the smallest angle: a smaller gain is not worth
// a change of the surface, and might repeat without end.
constexpr double Gain = 1.01;
// Cosine of 80 degrees, the largest angle between a changed face and the old surface: a guard against
// folds.
constexpr double LeastSliverAlignment = 0.17;

bool opensSmallAngle(const LocalChange& change)
{
  return smallestSine(change.After) > Gain * smallestSine(change.Before);
}

// The same without turning a face away from the old surface.
bool opensSmallAngleAligned(const LocalChange& change)
{
  const double aligned = smallestAlignment(change.After);
  return (aligned >= LeastSliverAlignment || aligned >= smallestAlignment(change.Before)) &&
         opensSmallAngle(change);
}

std::array<Halfedge, 3> edgesByLength(const MeshOnSurface& surface, Face face)
{
  const Halfedge h = surface.mesh().halfedge(face);
  std::array<Halfedge, 3> edges{ h, surface.mesh().next(h), surface.mesh().prev(h) };
  std::sort(edges.begin(),
    edges.end(),
    [&surface](Halfedge a, Halfedge b) { return surface.length(a) < surface.length(b); });
  return edges;
}

// Moves a vertex to the mean of its neighbours or part of the way there. Returns whether that was done.
bool moveInwards(MeshOnSurface& surface, Vertex v, const MeshOnSurface::Guard& guard)
{
  const Eigen::Vector3d here = surface.mesh().point(v);
  const Eigen::Vector3d mean = surface.meanOfNeighbours(v);
  for (const double share : { 1.0, 0.5, 0.25 })
  {
    const Eigen::Vector3d wanted = here + share * (mean - here);
    const SurfacePoint at = surface.walk().closest(wanted, surface.place(v).Face);
    if (surface.move(v, at, at.Position, guard))
    {
      return true;
    }
  }
  return false;
}

// Which changes may be made at the boundary.
enum class BoundaryRule
{
  Coarsened, // it may lose vertices where it is nearly straight
  Kept       // it stays, and no new edge inside joins two of its vertices
};

bool mayFlip(const MeshOnSurface& surface, Edge edge, BoundaryRule rule)
{
  const MeshOnSurface::Mesh& mesh = surface.mesh();
  const Halfedge h = mesh.halfedge(edge);
  return rule == BoundaryRule::Coarsened || mesh.is_border(edge) ||
         !surface.onBoundary(mesh.target(mesh.next(h))) ||
         !surface.onBoundary(mesh.target(mesh.next(mesh.opposite(h))));
}

// A collapse onto the boundary would join the neighbours of the lost vertex with it.
bool mayCollapse(const MeshOnSurface& surface, Edge edge, BoundaryRule rule)
{
  const Halfedge h = surface.mesh().halfedge(edge);
  return rule == BoundaryRule::Coarsened || (!surface.onBoundary(surface.mesh().source(h)) &&
                                              !surface.onBoundary(surface.mesh().target(h)));
}

// Tries one change after another, the mildest first, until one is made.
bool openAngles(MeshOnSurface& surface, Face face, BoundaryRule rule, const MeshOnSurface::Guard& guard)
{
  const MeshOnSurface::Mesh& mesh = surface.mesh();
  const std::array<Halfedge, 3> edges = edgesByLength(surface, face);
  const auto flip = [&](Halfedge h)
  { return mayFlip(surface, mesh.edge(h), rule) && surface.flip(mesh.edge(h), guard); };
  const auto collapse = [&](Halfedge h)
  { return mayCollapse(surface, mesh.edge(h), rule) && surface.collapse(mesh.edge(h), guard); };
  if (flip(edges[2]) || collapse(edges[0]))
  {
    return true;
  }
  for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
  {
    if (moveInwards(surface, v, guard))
    {
      return true;
    }
  }
  return flip(edges[1]) || flip(edges[0]) || collapse(edges[1]) || collapse(edges[2]);
}

void removeSlivers(MeshOnSurface& surface,
  double degrees,
  BoundaryRule rule,
  const ProgressCallback& progress)
{
  const double bound = std::sin(degrees * EIGEN_PI / 180.0);
  const double tiny = std::sin(slivers::TinyAngle * EIGEN_PI / 180.0);
  bool changed = true;
  for (int round = 0; changed && round < SliverRounds; ++round)
  {
    std::vector<Face> narrow;
    for (const Face f : surface.mesh().faces())
    {
      if (smallestSine(surface.triangle(f)) < bound)
      {
        narrow.push_back(f);
      }
    }
    changed = false;
    for (std::size_t i = 0; i < narrow.size(); ++i)
    {
      const Face f = narrow[i];
      if (i % FacesBetweenReports == 0)
      {
        report(progress, static_cast<double>(round) / SliverRounds, "opening small angles");
      }
      if (!surface.mesh().is_removed(f) && smallestSine(surface.triangle(f)) < bound)
      {
        changed |=
          openAngles(surface, f, rule, opensSmallAngleAligned) ||
          (smallestSine(surface.triangle(f)) < tiny && openAngles(surface, f, rule, opensSmallAngle));
      }
    }
  }
}

DerivedMesh withoutSmallAngles(const TriangleMesh& mesh,
  double degrees,
  BoundaryRule rule,
  const ProgressCallback& progress)
{
  if (smallestAngle(mesh) >= degrees)
  {
    return derivedFromItself(mesh);
  }
  MeshOnSurface surface(mesh);
  removeSlivers(surface, degrees, rule, progress);
  return surface.derived();
}

} // namespace

void removeSlivers(MeshOnSurface& surface, double degrees, const ProgressCallback& progress)
{
  removeSlivers(surface, degrees, BoundaryRule::Coarsened, progress);
}

DerivedMesh withoutSmallAngles(const TriangleMesh& mesh,
  double degrees,
  const ProgressCallback& progress)
{
  return withoutSmallAngles(mesh, degrees, BoundaryRule::Coarsened, progress);
}

DerivedMesh withoutSmallAnglesInside(const TriangleMesh& mesh,
  double degrees,
  const ProgressCallback& progress)
{
  return withoutSmallAngles(mesh, degrees, BoundaryRule::Kept, progress);
}

} // namespace flattening
