// SPDX-License-Identifier: GPL-3.0-or-later
#include "TangleSmoothing.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace flattening
{
namespace
{

using Vertex = ResampledSurface::Vertex;
using Face = ResampledSurface::Face;

constexpr int Sizes = 4; // in edges
constexpr int RoundsPerEdge = 4;
// Of the angles that smoothing may leave, 5 degrees and 1; unless they were smaller.
constexpr double LeastSines[] = { 0.0872, 0.0175 };

// Inner vertices up to so many edges away from a pair, ascending.
std::vector<Vertex> regionAround(const ResampledSurface& surface,
  const std::pair<Face, Face>& pair,
  int size)
{
  const ResampledSurface::Mesh& mesh = surface.mesh();
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

class TangleSmoother
{
public:
  TangleSmoother(ResampledSurface& surface, const std::vector<Face>& near)
    : Surface(surface)
    , Near(near)
  {
  }

  // Leaves all as it is unless fewer faces intersect then.
  void smooth(const std::vector<Vertex>& region, int rounds, double leastSine)
  {
    const std::size_t before = intersectingFaces(this->Surface, this->Near).size();
    const double sineBefore = std::min(leastSine, this->smallestSineAround(region));
    std::vector<std::pair<SurfacePoint, Eigen::Vector3d>> old;
    for (const Vertex v : region)
    {
      old.emplace_back(this->Surface.place(v), this->Surface.mesh().point(v));
    }
    for (int i = 0; i < rounds; ++i)
    {
      for (const Vertex v : region)
      {
        this->moveToMean(v);
      }
    }
    if (this->smallestSineAround(region) >= sineBefore &&
        intersectingFaces(this->Surface, this->Near).size() < before)
    {
      return;
    }
    for (std::size_t i = 0; i < region.size(); ++i)
    {
      this->place(region[i], old[i].first, old[i].second);
    }
  }

private:
  double smallestSineAround(const std::vector<Vertex>& region) const
  {
    const ResampledSurface::Mesh& mesh = this->Surface.mesh();
    double smallest = 1.0;
    for (const Vertex v : region)
    {
      for (const Face f : mesh.faces_around_target(mesh.halfedge(v)))
      {
        if (f != ResampledSurface::Mesh::null_face())
        {
          smallest = std::min(smallest, smallestSine(this->Surface.triangle(f)));
        }
      }
    }
    return smallest;
  }

  void moveToMean(Vertex v)
  {
    const ResampledSurface::Mesh& mesh = this->Surface.mesh();
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

  ResampledSurface& Surface;
  const std::vector<Face>& Near;
};

// Returns the pairs that are left.
FacePairs smoothRegions(ResampledSurface& surface, const FacePairs& pairs, int size, double leastSine)
{
  std::vector<std::vector<Vertex>> surroundings;
  for (const auto& pair : pairs)
  {
    surroundings.push_back(regionAround(surface, pair, size + 1));
  }
  const std::vector<std::vector<Face>> near = facesNear(surface, surroundings);
  const auto intersects = [&surface](const std::pair<Face, Face>& pair)
  { return intersect(placed(surface.triangle(pair.first)), placed(surface.triangle(pair.second))); };
  std::set<std::pair<Face, Face>> left;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    if (intersects(pairs[i]))
    {
      TangleSmoother(surface, near[i])
        .smooth(regionAround(surface, pairs[i], size), RoundsPerEdge * size, leastSine);
    }
    const FacePairs here = intersectingFaces(surface, near[i]);
    left.insert(here.begin(), here.end());
  }
  FacePairs result;
  std::copy_if(left.begin(), left.end(), std::back_inserter(result), intersects);
  return result;
}

} // namespace

FacePairs smoothTangles(ResampledSurface& surface, FacePairs pairs)
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
