// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/SelfIntersectionRemoval.h"

#include "Mesh/SelfIntersections.h"
#include "Mesh/SliverThresholds.h"
#include "Remeshing/IntersectionQueries.h"
#include "Remeshing/IntersectionSmoothing.h"
#include "Remeshing/SliverRemoval.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

using Vertex = MeshOnSurface::Vertex;
using Halfedge = MeshOnSurface::Halfedge;
using Face = MeshOnSurface::Face;

// Pairs that are left after so many rounds are left to smoothing: a guard against endless changes.
constexpr int Rounds = 5;

// The largest number of pairs for each face of the surface with which local changes are tried.
// Isosurfaces of scans have fewer than one pair in a thousand faces. A surface that is pressed flat has
// fifty in each face: there is no room to move faces to, and the attempt takes time that grows with the
// square of the faces.
constexpr double LargestPairShare = 0.1;

// Takes a pair of intersecting faces apart. Changes are tested against the faces near the pair.
class PairSeparation
{
public:
  PairSeparation(MeshOnSurface& surface, std::vector<Face> faces)
    : Surface(surface)
    , Faces(std::move(faces))
  {
  }

  // Returns whether anything was changed.
  bool separate(const FacePair& pair)
  {
    return intersect(this->Surface, pair) &&
           (this->changeAround(pair.first) || this->changeAround(pair.second));
  }

private:
  bool changeAround(Face face);
  bool moveToMean(Vertex v);
  bool improves(const LocalChange& change) const;
  int intersections(const LocalChange::Triangles& triangles,
    const LocalChange& change,
    int enough) const;

  MeshOnSurface& Surface;
  std::vector<Face> Faces;
};

// The number of intersections of the triangles with each other and with the faces that the change leaves
// alone. Stops at `enough`.
int PairSeparation::intersections(const LocalChange::Triangles& triangles,
  const LocalChange& change,
  int enough) const
{
  std::vector<PlacedTriangle> own;
  std::vector<Eigen::AlignedBox3d> boxes;
  Eigen::AlignedBox3d all;
  for (const CornerTriangle& triangle : triangles)
  {
    own.push_back(placed(triangle));
    boxes.push_back(own.back().box());
    all.extend(boxes.back());
  }
  int count = 0;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    for (std::size_t j = i + 1; j < own.size() && count < enough; ++j)
    {
      count += boxes[i].intersects(boxes[j]) && intersect(own[i], own[j]);
    }
  }
  for (std::size_t n = 0; n < this->Faces.size() && count < enough; ++n)
  {
    const Face f = this->Faces[n];
    const int index = static_cast<int>(f.idx());
    const PlacedTriangle other = placed(this->Surface.triangle(f));
    const Eigen::AlignedBox3d box = other.box();
    if (!all.intersects(box) ||
        std::find(change.Removed.begin(), change.Removed.end(), index) != change.Removed.end())
    {
      continue;
    }
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      count += boxes[i].intersects(box) && intersect(own[i], other);
    }
  }
  return count;
}

bool PairSeparation::improves(const LocalChange& change) const
{
  const double sine = smallestSine(change.After);
  if (sine < slivers::SeparatedSine && sine < smallestSine(change.Before))
  {
    return false;
  }
  const int before = this->intersections(change.Before, change, std::numeric_limits<int>::max());
  return this->intersections(change.After, change, before) < before;
}

// Moves the vertex to the mean of its neighbours, on the surface or else off it.
bool PairSeparation::moveToMean(Vertex v)
{
  const auto guard = [this](const LocalChange& change) { return this->improves(change); };
  const Eigen::Vector3d meanOfNeighbours = this->Surface.meanOfNeighbours(v);
  const SurfacePoint place = this->Surface.place(v);
  const SurfacePoint mean = this->Surface.walk().closest(meanOfNeighbours, place.Face);
  if (this->Surface.move(v, mean, mean.Position, guard))
  {
    return true;
  }
  return this->Surface.move(v, place, meanOfNeighbours, guard);
}

bool PairSeparation::changeAround(Face face)
{
  const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
  const auto guard = [this](const LocalChange& change) { return this->improves(change); };
  for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face)))
  {
    if (this->Surface.flip(mesh.edge(h), guard))
    {
      return true;
    }
  }
  for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
  {
    if (this->moveToMean(v))
    {
      return true;
    }
  }
  return false;
}

} // namespace

int removeSelfIntersections(MeshOnSurface& surface,
  const ProgressCallback& progress,
  TrackedIntersections* known)
{
  const char* stage = "removing self-intersections";
  report(progress, 0.0, stage);
  TrackedIntersections unknown;
  TrackedIntersections& tracked = known != nullptr ? *known : unknown;
  const auto found = intersectingFaces(surface, tracked, subrange(progress, 0.0, 0.5));
  if (!found || static_cast<double>(found->size()) > LargestPairShare * surface.mesh().number_of_faces())
  {
    return static_cast<int>(tracked.count());
  }
  FacePairs pairs = *found;
  for (int round = 0; !pairs.empty() && round < Rounds; ++round)
  {
    const ProgressCallback part =
      subrange(progress, 0.5 + 0.25 * round / Rounds, 0.5 + 0.25 * (round + 1) / Rounds);
    bool changed = false;
    std::vector<std::vector<Vertex>> around;
    for (const FacePair& pair : pairs)
    {
      report(part, 0.0, stage);
      around.push_back(verticesAround(surface, pair, 1)); // those that may move
    }
    const auto near = facesNear(surface, around);
    if (!near)
    {
      break;
    }
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      report(part, static_cast<double>(i) / pairs.size(), stage);
      changed |=
        (*near)[i].size() <= MostNearOnePair && PairSeparation(surface, (*near)[i]).separate(pairs[i]);
    }
    // Faces that moved are still among these.
    pairs = intersectingFaces(surface, unitedFaces(*near), atFraction(part, 1.0, stage));
    if (!changed)
    {
      break;
    }
  }
  return static_cast<int>(
    smoothIntersections(surface, std::move(pairs), subrange(progress, 0.75, 1.0)).size());
}

DerivedMesh conditionFaces(const TriangleMesh& mesh,
  double degrees,
  const ProgressCallback& progress,
  TrackedIntersections* known)
{
  MeshOnSurface surface(mesh);
  removeSlivers(surface, degrees, subrange(progress, 0.0, 0.5));
  removeSelfIntersections(surface, subrange(progress, 0.5, 1.0), known);
  return surface.derived();
}

} // namespace flattening
