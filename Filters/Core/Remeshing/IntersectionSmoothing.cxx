// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/IntersectionSmoothing.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace flattening
{
namespace
{

using Vertex = MeshOnSurface::Vertex;
using Face = MeshOnSurface::Face;

constexpr int Sizes = 4; // in edges
constexpr int RoundsPerEdge = 4;
// Of the angles that smoothing may leave, 5 degrees and 1; unless they were smaller.
constexpr double LeastSines[] = { 0.0872, 0.0175 };

// Inner vertices up to so many edges away from a pair, ascending.
std::vector<Vertex> regionAround(const MeshOnSurface& surface,
  const std::pair<Face, Face>& pair,
  int size)
{
  const MeshOnSurface::Mesh& mesh = surface.mesh();
  std::set<Vertex> region;
  for (const Face f : { pair.first, pair.second })
  {
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
    {
      region.insert(v);
    }
  }
  for (int i = 0; i < size; ++i)
  {
    const std::vector<Vertex> inner(region.begin(), region.end());
    for (const Vertex v : inner)
    {
      for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(v)))
      {
        region.insert(w);
      }
    }
  }
  std::vector<Vertex> result;
  std::copy_if(region.begin(),
    region.end(),
    std::back_inserter(result),
    [&surface](Vertex v) { return !surface.onBoundary(v); });
  return result;
}

// The faces around the vertices, ascending.
std::vector<Face> facesOf(const MeshOnSurface& surface, const std::vector<Vertex>& region)
{
  const MeshOnSurface::Mesh& mesh = surface.mesh();
  std::vector<Face> faces;
  for (const Vertex v : region)
  {
    for (const Face f : mesh.faces_around_target(mesh.halfedge(v)))
    {
      if (f != MeshOnSurface::Mesh::null_face())
      {
        faces.push_back(f);
      }
    }
  }
  return unitedFaces({ faces });
}

class TangleSmoother
{
public:
  TangleSmoother(MeshOnSurface& surface, std::vector<Vertex> region)
    : Surface(surface)
    , Region(std::move(region))
    , Faces(facesOf(surface, this->Region))
  {
  }

  // Leaves all as it is unless fewer faces intersect then.
  void smooth(const std::vector<Face>& near, int rounds, double leastSine)
  {
    const int before = countIntersections(this->Surface, this->Faces, near);
    const double sineBefore = std::min(leastSine, this->smallestSine());
    std::vector<std::pair<SurfacePoint, Eigen::Vector3d>> old;
    for (const Vertex v : this->Region)
    {
      old.emplace_back(this->Surface.place(v), this->Surface.mesh().point(v));
    }
    for (int i = 0; i < rounds; ++i)
    {
      for (const Vertex v : this->Region)
      {
        this->moveToMean(v);
      }
    }
    if (this->smallestSine() >= sineBefore &&
        countIntersections(this->Surface, this->Faces, near) < before)
    {
      return;
    }
    for (std::size_t i = 0; i < this->Region.size(); ++i)
    {
      this->place(this->Region[i], old[i].first, old[i].second);
    }
  }

private:
  double smallestSine() const
  {
    double smallest = 1.0;
    for (const Face f : this->Faces)
    {
      smallest = std::min(smallest, flattening::smallestSine(this->Surface.triangle(f)));
    }
    return smallest;
  }

  void moveToMean(Vertex v)
  {
    const MeshOnSurface::Mesh& mesh = this->Surface.mesh();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int neighbours = 0;
    for (const Vertex w : mesh.vertices_around_target(mesh.halfedge(v)))
    {
      sum += mesh.point(w);
      ++neighbours;
    }
    const Eigen::Vector3d mean = sum / neighbours;
    this->place(v, this->Surface.walk().closest(mean, this->Surface.place(v).Face), mean);
  }

  void place(Vertex v, const SurfacePoint& at, const Eigen::Vector3d& position)
  {
    this->Surface.move(v, at, position, [](const LocalChange&) { return true; });
  }

  MeshOnSurface& Surface;
  std::vector<Vertex> Region;
  std::vector<Face> Faces;
};

// Returns the pairs that are left.
FacePairs smoothRegions(MeshOnSurface& surface, const FacePairs& pairs, int size, double leastSine)
{
  std::vector<std::vector<Vertex>> surroundings;
  for (const auto& pair : pairs)
  {
    surroundings.push_back(regionAround(surface, pair, size + 1));
  }
  const std::vector<std::vector<Face>> near = facesNear(surface, surroundings);
  const auto intersects = [&surface](const std::pair<Face, Face>& pair)
  { return intersect(placed(surface.triangle(pair.first)), placed(surface.triangle(pair.second))); };
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    if (intersects(pairs[i]))
    {
      TangleSmoother(surface, regionAround(surface, pairs[i], size))
        .smooth(near[i], RoundsPerEdge * size, leastSine);
    }
  }
  return intersectingFaces(surface, unitedFaces(near));
}

} // namespace

FacePairs smoothIntersections(MeshOnSurface& surface, FacePairs pairs)
{
  for (const double leastSine : LeastSines)
  {
    for (int size = 1; size <= Sizes && !pairs.empty(); ++size)
    {
      pairs = smoothRegions(surface, pairs, size, leastSine);
    }
  }
  return pairs;
}

} // namespace flattening
