// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/SliverRemoval.h"

#include "Mesh/MeshMeasures.h"

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
using Halfedge = MeshOnSurface::Halfedge;
using Face = MeshOnSurface::Face;

constexpr int Rounds = 10;
constexpr double Gain = 1.01;           // less is not worth a change
constexpr double TinyAngle = 5.0;       // degrees; below, the surface's shape matters less
constexpr double LeastAlignment = 0.17; // 80 degrees against the old surface's normals

bool opensSmallAngle(const LocalChange& change)
{
  return smallestSine(change.After) > Gain * smallestSine(change.Before);
}

bool opensSmallAngleSoundly(const LocalChange& change)
{
  const double aligned = smallestAlignment(change.After);
  return (aligned >= LeastAlignment || aligned >= smallestAlignment(change.Before)) &&
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

// To places between where it is and the mean of its neighbours.
bool moveInwards(MeshOnSurface& surface, Vertex v, const MeshOnSurface::Guard& guard)
{
  const MeshOnSurface::Mesh& mesh = surface.mesh();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int neighbours = 0;
  for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
  {
    sum += mesh.point(mesh.source(h));
    ++neighbours;
  }
  const Eigen::Vector3d here = mesh.point(v);
  for (const double share : { 1.0, 0.5, 0.25 })
  {
    const Eigen::Vector3d wanted = here + share * (sum / neighbours - here);
    const SurfacePoint at = surface.walk().closest(wanted, surface.place(v).Face);
    if (surface.move(v, at, at.Position, guard))
    {
      return true;
    }
  }
  return false;
}

bool openAngles(MeshOnSurface& surface, Face face, const MeshOnSurface::Guard& guard)
{
  const MeshOnSurface::Mesh& mesh = surface.mesh();
  const std::array<Halfedge, 3> edges = edgesByLength(surface, face);
  if (surface.flip(mesh.edge(edges[2]), guard) || surface.collapse(mesh.edge(edges[0]), guard))
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
  return surface.flip(mesh.edge(edges[1]), guard) || surface.flip(mesh.edge(edges[0]), guard) ||
         surface.collapse(mesh.edge(edges[1]), guard) || surface.collapse(mesh.edge(edges[2]), guard);
}

// Of two angles in [0, pi], one at each apex over the same base: whether they sum to more than pi.
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

} // namespace

void removeSlivers(MeshOnSurface& surface, double degrees, const ProgressCallback& progress)
{
  const double bound = std::sin(degrees * EIGEN_PI / 180.0);
  const double tiny = std::sin(TinyAngle * EIGEN_PI / 180.0);
  bool changed = true;
  for (int round = 0; changed && round < Rounds; ++round)
  {
    report(progress, static_cast<double>(round) / Rounds, "opening small angles");
    std::vector<Face> narrow;
    for (const Face f : surface.mesh().faces())
    {
      if (smallestSine(surface.triangle(f)) < bound)
      {
        narrow.push_back(f);
      }
    }
    changed = false;
    for (const Face f : narrow)
    {
      if (!surface.mesh().is_removed(f) && smallestSine(surface.triangle(f)) < bound)
      {
        changed |= openAngles(surface, f, opensSmallAngleSoundly) ||
                   (smallestSine(surface.triangle(f)) < tiny && openAngles(surface, f, opensSmallAngle));
      }
    }
  }
}

DerivedMesh withoutSmallAngles(const TriangleMesh& mesh,
  double degrees,
  const ProgressCallback& progress)
{
  if (smallestAngle(mesh) >= degrees)
  {
    return derivedFromItself(mesh);
  }
  MeshOnSurface surface(mesh);
  removeSlivers(surface, degrees, progress);
  return surface.derived();
}

bool opensAngles(const LocalChange& flip)
{
  const CornerTriangle& left = flip.Before[0];
  const CornerTriangle& right = flip.Before[1];
  return sumExceedsPi(*left[2].Position, *right[2].Position, *left[0].Position, *left[1].Position);
}

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

} // namespace flattening
