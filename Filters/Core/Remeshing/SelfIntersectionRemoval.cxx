// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/SelfIntersectionRemoval.h"

#include "Mesh/SelfIntersections.h"
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

constexpr int Rounds = 5;
constexpr double LeastSine = 0.17; // of 10 degrees
// Of the mean length of the edges around a vertex.
constexpr double Steps[] = { 0.02, 0.05, 0.1, 0.2, 0.4 };

using Box = Eigen::AlignedBox3d;

Box boxOf(const PlacedTriangle& triangle)
{
  Box box(triangle.Points[0]);
  return box.extend(triangle.Points[1]).extend(triangle.Points[2]);
}

// The faces near a pair of intersecting ones, against which changes there are tested.
class Neighbourhood
{
public:
  Neighbourhood(MeshOnSurface& surface, std::vector<Face> faces)
    : Surface(surface)
    , Faces(std::move(faces))
  {
  }

  bool untangle(Face one, Face other)
  {
    return this->intersect(one, other) && (this->changeAround(one) || this->changeAround(other));
  }

private:
  bool intersect(Face a, Face b) const
  {
    return flattening::intersect(placed(this->Surface.triangle(a)), placed(this->Surface.triangle(b)));
  }

  bool changeAround(Face face);
  bool moveOff(Vertex v);
  bool improves(const LocalChange& change) const;
  int intersections(const LocalChange::Triangles& triangles,
    const LocalChange& change,
    int enough) const;

  MeshOnSurface& Surface;
  std::vector<Face> Faces;
};

// Of the triangles with each other and with the faces that the change leaves alone. Stops at `enough`.
int Neighbourhood::intersections(const LocalChange::Triangles& triangles,
  const LocalChange& change,
  int enough) const
{
  std::vector<PlacedTriangle> own;
  std::vector<Box> boxes;
  Box all;
  for (const CornerTriangle& triangle : triangles)
  {
    own.push_back(placed(triangle));
    boxes.push_back(boxOf(own.back()));
    all.extend(boxes.back());
  }
  int count = 0;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    for (std::size_t j = i + 1; j < own.size() && count < enough; ++j)
    {
      count += boxes[i].intersects(boxes[j]) && flattening::intersect(own[i], own[j]);
    }
  }
  for (std::size_t n = 0; n < this->Faces.size() && count < enough; ++n)
  {
    const Face f = this->Faces[n];
    const int index = static_cast<int>(f.idx());
    const PlacedTriangle other = placed(this->Surface.triangle(f));
    const Box box = boxOf(other);
    if (!all.intersects(box) ||
        std::find(change.Removed.begin(), change.Removed.end(), index) != change.Removed.end())
    {
      continue;
    }
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      count += boxes[i].intersects(box) && flattening::intersect(own[i], other);
    }
  }
  return count;
}

bool Neighbourhood::improves(const LocalChange& change) const
{
  const double sine = smallestSine(change.After);
  if (sine < LeastSine && sine < smallestSine(change.Before))
  {
    return false;
  }
  const int before = this->intersections(change.Before, change, std::numeric_limits<int>::max());
  return this->intersections(change.After, change, before) < before;
}

bool Neighbourhood::moveOff(Vertex v)
{
  const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
  const auto guard = [this](const LocalChange& change) { return this->improves(change); };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double lengths = 0.0;
  int neighbours = 0;
  for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
  {
    sum += mesh.point(mesh.source(h));
    lengths += this->Surface.length(h);
    ++neighbours;
  }
  const Eigen::Vector3d here = mesh.point(v);
  const SurfacePoint place = this->Surface.place(v);
  const SurfacePoint mean = this->Surface.walk().closest(sum / neighbours, place.Face);
  if (this->Surface.move(v, mean, mean.Position, guard))
  {
    return true;
  }
  const Eigen::Vector3d normal = this->Surface.walk().normal(place);
  for (const double step : Steps)
  {
    for (const double side : { -1.0, 1.0 })
    {
      const Eigen::Vector3d moved = here + side * step * lengths / neighbours * normal;
      if (this->Surface.move(v, this->Surface.walk().closest(moved, place.Face), moved, guard))
      {
        return true;
      }
    }
  }
  return this->Surface.move(v, place, sum / neighbours, guard);
}

bool Neighbourhood::changeAround(Face face)
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
    if (this->moveOff(v))
    {
      return true;
    }
  }
  return false;
}

// All that may move where a pair intersects.
std::vector<Vertex> verticesAround(const MeshOnSurface& surface, const std::pair<Face, Face>& pair)
{
  const MeshOnSurface::Mesh& mesh = surface.mesh();
  std::vector<Vertex> around;
  for (const Face f : { pair.first, pair.second })
  {
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
    {
      const auto neighbours = mesh.vertices_around_target(mesh.halfedge(v));
      around.insert(around.end(), neighbours.begin(), neighbours.end());
    }
  }
  return around;
}

} // namespace

int removeSelfIntersections(MeshOnSurface& surface, const ProgressCallback& progress)
{
  report(progress, 0.0, "removing self-intersections");
  FacePairs pairs = intersectingFaces(surface, subrange(progress, 0.0, 0.5));
  for (int round = 0; !pairs.empty() && round < Rounds; ++round)
  {
    report(progress, 0.5 + 0.5 * round / Rounds, "removing self-intersections");
    bool changed = false;
    std::vector<std::vector<Vertex>> around;
    for (const auto& pair : pairs)
    {
      around.push_back(verticesAround(surface, pair));
    }
    const std::vector<std::vector<Face>> near = facesNear(surface, around);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      changed |= Neighbourhood(surface, near[i]).untangle(pairs[i].first, pairs[i].second);
    }
    pairs = intersectingFaces(surface, unitedFaces(near)); // what moved is still among those
    if (!changed)
    {
      break;
    }
  }
  return static_cast<int>(smoothIntersections(surface, std::move(pairs)).size());
}

} // namespace flattening
