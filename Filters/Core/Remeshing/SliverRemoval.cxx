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

// Which changes may be made at the boundary.
enum class BoundaryRule
{
  Coarsened, // it may lose vertices where it is nearly straight
  Kept       // it stays, and no new edge inside joins two of its vertices
};

// Opens the small angles of a surface, one face after another.
class SliverOpener
{
public:
  // @param degrees angles below this one are opened
  SliverOpener(MeshOnSurface& surface, double degrees, BoundaryRule rule)
    : Surface(surface)
    , Rule(rule)
    , MostFaces(static_cast<int>(FullTurns * 360.0 / degrees))
    , Bound(std::sin(degrees * EIGEN_PI / 180.0))
  {
  }

  void run(const ProgressCallback& progress)
  {
    bool changed = true;
    for (int round = 0; changed && round < SliverRounds; ++round)
    {
      changed = false;
      const std::vector<Face> narrow = this->narrowFaces();
      for (std::size_t i = 0; i < narrow.size(); ++i)
      {
        if (i % FacesBetweenReports == 0)
        {
          report(progress, static_cast<double>(round) / SliverRounds, "opening small angles");
        }
        changed |= this->open(narrow[i]);
      }
    }
  }

private:
  // The angles at a vertex add up to about one full turn, and to less than two unless the surface is
  // crumpled.
  static constexpr double FullTurns = 2.0;

  std::vector<Face> narrowFaces() const
  {
    std::vector<Face> narrow;
    for (const Face f : this->Surface.mesh().faces())
    {
      if (smallestSine(this->Surface.triangle(f)) < this->Bound)
      {
        narrow.push_back(f);
      }
    }
    return narrow;
  }

  bool open(Face f)
  {
    const double tiny = std::sin(slivers::TinyAngle * EIGEN_PI / 180.0);
    return !this->Surface.mesh().is_removed(f) &&
           smallestSine(this->Surface.triangle(f)) < this->Bound &&
           (this->openAngles(f, opensSmallAngleAligned) ||
             (smallestSine(this->Surface.triangle(f)) < tiny && this->openAngles(f, opensSmallAngle)));
  }

  // Tries one change after another, the mildest first, until one is made.
  bool openAngles(Face face, const MeshOnSurface::Guard& guard)
  {
    const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
    const std::array<Halfedge, 3> edges = edgesByLength(this->Surface, face);
    const auto flip = [&](Halfedge h)
    { return this->mayFlip(mesh.edge(h)) && this->Surface.flip(mesh.edge(h), guard); };
    const auto collapse = [&](Halfedge h)
    { return this->mayCollapse(h) && this->Surface.collapse(mesh.edge(h), guard); };
    if (flip(edges[2]) || collapse(edges[0]))
    {
      return true;
    }
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
    {
      if (this->moveInwards(v, guard))
      {
        return true;
      }
    }
    return flip(edges[1]) || flip(edges[0]) || collapse(edges[1]) || collapse(edges[2]);
  }

  // Moves a vertex to the mean of its neighbours or part of the way there. Returns whether that was
  // done.
  bool moveInwards(Vertex v, const MeshOnSurface::Guard& guard)
  {
    if (this->isCrowded(v))
    {
      return false;
    }
    const Eigen::Vector3d here = this->Surface.mesh().point(v);
    const Eigen::Vector3d mean = this->Surface.meanOfNeighbours(v);
    for (const double share : { 1.0, 0.5, 0.25 })
    {
      const Eigen::Vector3d wanted = here + share * (mean - here);
      const SurfacePoint at = this->Surface.walk().closest(wanted, this->Surface.place(v).Face);
      if (this->Surface.move(v, at, at.Position, guard))
      {
        return true;
      }
    }
    return false;
  }

  bool mayFlip(Edge edge) const
  {
    const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
    const Halfedge h = mesh.halfedge(edge);
    return this->Rule == BoundaryRule::Coarsened || mesh.is_border(edge) ||
           !this->Surface.onBoundary(mesh.target(mesh.next(h))) ||
           !this->Surface.onBoundary(mesh.target(mesh.next(mesh.opposite(h))));
  }

  // A collapse onto the boundary would join the neighbours of the lost vertex with it.
  bool mayCollapse(Halfedge h) const
  {
    const Vertex a = this->Surface.mesh().source(h);
    const Vertex b = this->Surface.mesh().target(h);
    return (this->Rule == BoundaryRule::Coarsened ||
             (!this->Surface.onBoundary(a) && !this->Surface.onBoundary(b))) &&
           !this->isCrowded(a) && !this->isCrowded(b);
  }

  // Whether so many faces meet at a vertex that some of its angles are small wherever it lies. To move
  // it is of no use, and to try that for each of these faces would take a time that grows with their
  // square.
  bool isCrowded(Vertex v) const
  {
    const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
    int faces = 0;
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      if (!mesh.is_border(h) && ++faces > this->MostFaces)
      {
        return true;
      }
    }
    return false;
  }

  MeshOnSurface& Surface;
  BoundaryRule Rule;
  int MostFaces; // around a vertex that is not crowded
  double Bound;  // sine of the smallest angle that is large enough
};

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
  SliverOpener(surface, degrees, rule).run(progress);
  return surface.derived();
}

} // namespace

void removeSlivers(MeshOnSurface& surface, double degrees, const ProgressCallback& progress)
{
  SliverOpener(surface, degrees, BoundaryRule::Coarsened).run(progress);
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
