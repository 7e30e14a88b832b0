// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/SeamPlacement.h"

#include "Base/Errors.h"
#include "Geodesics/DijkstraDistance.h"
#include "Geodesics/GeodesicPath.h"
#include "Mesh/EditableSurface.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace flattening
{
namespace
{

using Vertex = SurfaceMesh::Vertex_index;

// The least distance of the seam from the region to be avoided, where there is room, and the least
// length of the seam, in square roots of the surface's area. Conventions: with a larger clearance there
// is no seam on small surfaces, with none the seam may touch the region; a shorter seam is hardly a
// boundary.
constexpr double SeamClearance = 0.02;
constexpr double ShortestSeam = 0.02;

struct Stretch
{
  Eigen::Vector3d From;
  Eigen::Vector3d To;
  double Length = 0.0;
};

class SeamPlacer
{
public:
  SeamPlacer(const TriangleMesh& mesh, const std::vector<char>& avoided)
    : Surface(toSurfaceMesh(mesh))
    , DistanceFromAvoided(distancesFromFlagged(this->Surface, avoided))
    , Unit(std::sqrt(faceAreas(mesh.Vertices, mesh.Faces).sum()))
  {
  }

  std::vector<Eigen::Vector3d> place(const ProgressCallback& progress)
  {
    report(progress, 0.0, "placing the seam");
    for (const double clearance : { SeamClearance, 0.5 * SeamClearance, 0.0 })
    {
      this->Blocked.resize(this->Surface.number_of_vertices());
      std::transform(this->DistanceFromAvoided.begin(),
        this->DistanceFromAvoided.end(),
        this->Blocked.begin(),
        [&](double distance) { return distance <= clearance * this->Unit; });
      const Vertex middle = this->farthest(this->DistanceFromAvoided);
      const Vertex from = this->farthest(this->distancesFrom(middle));
      const Vertex to = this->farthest(this->distancesFrom(from));
      Stretch best = this->longestFreeStretch(from, to, subrange(progress, 0.3, 0.6));
      if (!this->mayBeAnywhere())
      {
        // The geodesic between two ends at the border of the region may run through the region.
        for (const Vertex end : { from, to })
        {
          const Stretch half = this->longestFreeStretch(middle, end, subrange(progress, 0.6, 1.0));
          best = half.Length > best.Length ? half : best;
        }
      }
      if (best.Length > ShortestSeam * this->Unit)
      {
        return { best.From, best.To };
      }
    }
    throw InvalidInput("the region of interest leaves no room for a seam: mark a smaller part of the "
                       "surface, or set the points of the seam");
  }

private:
  Vertex farthest(const Eigen::VectorXd& distances) const
  {
    return Vertex(static_cast<SurfaceMesh::size_type>(indexOfLargest(distances)));
  }

  // Distances along edges; -1 for vertices that no free path reaches.
  Eigen::VectorXd distancesFrom(Vertex source) const
  {
    const Eigen::VectorXd distances = distancesAlongEdges(this->Surface, { source }, this->Blocked);
    return distances.array().isFinite().select(distances, -1.0);
  }

  bool mayBeAnywhere() const { return !std::isfinite(this->DistanceFromAvoided[0]); }

  // The longest part of the geodesic that has no blocked vertex beside it.
  Stretch longestFreeStretch(Vertex from, Vertex to, const ProgressCallback& progress) const
  {
    Stretch longest;
    if (from == to)
    {
      return longest;
    }
    const GeodesicPath path = geodesicPath(this->Surface, from, to, progress);
    Stretch stretch;
    bool isFree = false;
    for (const PathPoint& point : path.Points)
    {
      const Eigen::Vector3d position = positionOf(this->Surface, point);
      const bool starts = !isFree;
      isFree = !this->isBlocked(point);
      if (!isFree || starts)
      {
        stretch = { position, position, 0.0 };
        continue;
      }
      stretch.Length += (position - stretch.To).norm();
      stretch.To = position;
      longest = stretch.Length > longest.Length ? stretch : longest;
    }
    return longest;
  }

  bool isBlocked(const PathPoint& point) const
  {
    return point.isVertex() ? this->Blocked[point.Vertex]
                            : this->Blocked[this->Surface.source(point.Edge)] ||
                                this->Blocked[this->Surface.target(point.Edge)];
  }

  const SurfaceMesh Surface;
  const Eigen::VectorXd DistanceFromAvoided; // infinite if there is no region
  const double Unit;
  std::vector<char> Blocked; // per vertex: whether the seam may not be there
};

} // namespace

std::vector<Eigen::Vector3d> placeSeam(const TriangleMesh& mesh,
  const std::vector<char>& avoided,
  const ProgressCallback& progress)
{
  if (!avoided.empty() && avoided.size() != static_cast<std::size_t>(mesh.vertexCount()))
  {
    throw InvalidInput("the region that the seam must avoid has " + std::to_string(avoided.size()) +
                       " flags, but the surface has " + std::to_string(mesh.vertexCount()) +
                       " vertices: pass one flag per vertex");
  }
  return SeamPlacer(mesh, avoided).place(progress);
}

} // namespace flattening
