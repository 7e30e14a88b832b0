// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/IntersectionSmoothing.h"

#include "Mesh/SliverThresholds.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace flattening
{
namespace
{

using Vertex = MeshOnSurface::Vertex;
using Face = MeshOnSurface::Face;

// The largest distance from a pair, in edges, of the vertices that are smoothed. A larger region draws
// deeper folds in, and moves more of the surface.
constexpr int LargestRegion = 4;
// Rounds of smoothing for each edge of that distance. Every round carries a change on by one edge at
// least: with fewer than one round, vertices at a pair would not feel the region's rim.
constexpr int RoundsPerEdge = 4;

constexpr const char* SmoothingStage = "smoothing where faces intersect";

// The inner vertices at most so many edges away from a pair, ascending.
std::vector<Vertex> innerVerticesAround(const MeshOnSurface& surface, const FacePair& pair, int edges)
{
  std::vector<Vertex> region = verticesAround(surface, pair, edges);
  region.erase(
    std::remove_if(region.begin(), region.end(), [&surface](Vertex v) { return surface.onBoundary(v); }),
    region.end());
  return region;
}

// The faces around inner vertices, ascending.
std::vector<Face> facesAround(const MeshOnSurface& surface, const std::vector<Vertex>& region)
{
  const MeshOnSurface::Mesh& mesh = surface.mesh();
  std::vector<Face> faces;
  for (const Vertex v : region)
  {
    const auto star = mesh.faces_around_target(mesh.halfedge(v));
    faces.insert(faces.end(), star.begin(), star.end());
  }
  return unitedFaces({ faces });
}

class RegionSmoother
{
public:
  RegionSmoother(MeshOnSurface& surface, std::vector<Vertex> region)
    : Surface(surface)
    , Region(std::move(region))
    , Faces(facesAround(surface, this->Region))
  {
  }

  // Undone unless fewer faces intersect afterwards and no angle becomes too small.
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
    const Eigen::Vector3d mean = this->Surface.meanOfNeighbours(v);
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

// Returns the pairs that are left; nothing if too many faces are near them.
std::optional<FacePairs> smoothRegions(MeshOnSurface& surface,
  const FacePairs& pairs,
  int size,
  double leastSine,
  const ProgressCallback& progress)
{
  std::vector<std::vector<Vertex>> surroundings;
  for (const FacePair& pair : pairs)
  {
    report(progress, 0.0, SmoothingStage);
    surroundings.push_back(innerVerticesAround(surface, pair, size + 1));
    if (surroundings.back().empty())
    {
      surroundings.back() = verticesAround(surface, pair, size + 1);
    }
  }
  const auto near = facesNear(surface, surroundings);
  if (!near)
  {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    report(progress, static_cast<double>(i) / pairs.size(), SmoothingStage);
    if ((*near)[i].size() <= MostNearOnePair && intersect(surface, pairs[i]))
    {
      RegionSmoother(surface, innerVerticesAround(surface, pairs[i], size))
        .smooth((*near)[i], RoundsPerEdge * size, leastSine);
    }
  }
  return intersectingFaces(surface, unitedFaces(*near), atFraction(progress, 1.0, SmoothingStage));
}

} // namespace

FacePairs smoothIntersections(MeshOnSurface& surface, FacePairs pairs, const ProgressCallback& progress)
{
  constexpr double Steps = LargestRegion * std::size(slivers::SmoothedSines);
  int done = 0;
  for (const double leastSine : slivers::SmoothedSines)
  {
    for (int size = 1; size <= LargestRegion && !pairs.empty(); ++size)
    {
      const ProgressCallback part = subrange(progress, done / Steps, (done + 1) / Steps);
      std::optional<FacePairs> left = smoothRegions(surface, pairs, size, leastSine, part);
      ++done;
      if (!left)
      {
        break; // and more faces are near to larger regions
      }
      pairs = std::move(*left);
    }
  }
  return pairs;
}

} // namespace flattening
