// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/SeamWayPoints.h"

#include "Base/Errors.h"
#include "Disk/PathInsertion.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/SurfacePick.h"

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Vertex = EditableSurface::Vertex;
using Halfedge = EditableSurface::Halfedge;
using Face = EditableSurface::Face;

// The least distance of consecutive points, as a share of the surface's diagonal. A guard: refinement
// between closer points would go down to rounding.
constexpr double SmallestStep = 1e-6;

constexpr const char* PlacingStage = "placing the seam";

SurfacePoint cornerOf(const TriangleMesh& mesh, int face, int vertex)
{
  SurfacePoint point{ face, mesh.Vertices.row(vertex), { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    point.Weights[k] = mesh.Faces(face, k) == vertex ? 1.0 : 0.0;
  }
  return point;
}

// Checks that every path has two points.
void requirePaths(const GeodesicSeamOptions& options)
{
  std::size_t begin = 0;
  std::vector<int> ends = options.PathStarts;
  ends.push_back(static_cast<int>(options.Points.size()));
  for (std::size_t k = 0; k < ends.size(); ++k)
  {
    if (ends[k] < static_cast<int>(begin) + 2 || ends[k] > static_cast<int>(options.Points.size()))
    {
      throw InvalidInput("path " + std::to_string(k + 1) + " of the seam ends before point " +
                         std::to_string(ends[k] + 1) +
                         ": a path needs two points or more, and there are " +
                         std::to_string(options.Points.size()) + " points");
    }
    begin = static_cast<std::size_t>(ends[k]);
  }
}

class WayPointInserter
{
public:
  WayPointInserter(EditableSurface& surface,
    const TriangleMesh& original,
    const MeshTopology& topology,
    const GeodesicSeamOptions& options,
    std::size_t edgesWanted)
    : Surface(surface)
    , Original(original)
    , Topology(topology)
    , Options(options)
    , EdgesWanted(edgesWanted)
    , Diagonal(boxDiagonal(original))
  {
    std::size_t begin = 0;
    for (const int start : options.PathStarts)
    {
      this->Points.Paths.push_back({ begin, static_cast<std::size_t>(start) });
      begin = static_cast<std::size_t>(start);
    }
    this->Points.Paths.push_back({ begin, options.Points.size() });
  }

  SeamWayPoints insert(const ProgressCallback& progress)
  {
    requirePaths(this->Options);
    std::vector<SurfacePoint> picked = this->pickPoints(subrange(progress, 0.0, 0.5));
    if (!this->Topology.BoundaryLoops.empty())
    {
      for (const SeamPath& path : this->Points.Paths)
      {
        this->endOnBoundary(path, picked);
      }
      if (this->Points.OnBoundary.empty())
      {
        throw TopologyError(
          "the surface has a boundary, and the seam neither starts nor ends on it: put its "
          "first or last point onto the boundary, or flatten the surface as it is");
      }
    }
    const double length = this->lengthThrough(picked);
    this->insertPicked(
      picked, length / static_cast<double>(this->EdgesWanted), subrange(progress, 0.5, 1.0));
    for (const SeamPath& path : this->Points.Paths)
    {
      this->requireDistinct(path);
    }
    return this->Points;
  }

private:
  // The points on the surface. Leaves points out where they are denser than the edges.
  std::vector<SurfacePoint> pickPoints(const ProgressCallback& progress)
  {
    const ClosestPointTree projection(this->Original, atFraction(progress, 0.0, PlacingStage));
    std::vector<SurfacePoint> picked;
    std::vector<char> areShared; // per point that is kept: whether it must be
    std::vector<SeamPath> paths;
    for (const SeamPath& path : this->Points.Paths)
    {
      const std::size_t begin = picked.size();
      for (std::size_t i = path.Begin; i < path.End; ++i)
      {
        report(progress, static_cast<double>(i) / this->Options.Points.size(), PlacingStage);
        SurfacePoint point = pickOnSurface(projection,
          this->Diagonal,
          this->Options.Points[i],
          "point " + std::to_string(i + 1) + " of the seam");
        const bool isShared = !this->Options.AreDense || this->isEndOfAPath(i);
        const auto isClose = [&]
        {
          return (point.Position - picked.back().Position).norm() <=
                 this->Surface.longestEdge(Face(point.Face));
        };
        if (i + 1 == path.End)
        {
          while (picked.size() > begin + 1 && !areShared.back() && isClose())
          {
            picked.pop_back();
            areShared.pop_back();
          }
        }
        if (isShared || !isClose())
        {
          picked.push_back(point);
          areShared.push_back(isShared);
        }
      }
      paths.push_back({ begin, picked.size() });
    }
    this->Points.Paths = std::move(paths);
    return picked;
  }

  // Makes the points vertices. Consecutive dense points that fall on the same vertex become one.
  void insertPicked(const std::vector<SurfacePoint>& picked,
    double longestEdge,
    const ProgressCallback& progress)
  {
    std::vector<std::size_t> onBoundary;
    std::vector<Vertex>& vertices = this->Points.Vertices;
    for (SeamPath& path : this->Points.Paths)
    {
      const std::size_t begin = vertices.size();
      for (std::size_t i = path.Begin; i < path.End; ++i)
      {
        report(progress, static_cast<double>(i) / picked.size(), PlacingStage);
        const Vertex v = insertPoint(this->Surface, picked[i], longestEdge);
        if (!this->Options.AreDense || vertices.size() == begin || vertices.back() != v)
        {
          vertices.push_back(v);
        }
        if (this->Points.isOnBoundary(i))
        {
          onBoundary.push_back(vertices.size() - 1);
        }
      }
      path = { begin, vertices.size() };
    }
    this->Points.OnBoundary = std::move(onBoundary);
  }

  // Whether a path begins or ends exactly at the point.
  bool isEndOfAPath(std::size_t i) const
  {
    const std::vector<Eigen::Vector3d>& points = this->Options.Points;
    const auto endsHere = [&](int start)
    { return points[start - 1] == points[i] || points[start] == points[i]; };
    return points.front() == points[i] || points.back() == points[i] ||
           std::any_of(this->Options.PathStarts.begin(), this->Options.PathStarts.end(), endsHere);
  }

  // The sum of the distances between consecutive points, which must be apart from each other.
  double lengthThrough(const std::vector<SurfacePoint>& picked) const
  {
    double length = 0.0;
    for (const SeamPath& path : this->Points.Paths)
    {
      for (std::size_t i = path.Begin; i + 1 < path.End; ++i)
      {
        const double step = (picked[i + 1].Position - picked[i].Position).norm();
        if (!(step > SmallestStep * this->Diagonal))
        {
          throw InvalidInput(coincidence(i, i + 1));
        }
        length += step;
      }
    }
    return length;
  }

  // Checks that the points of a path became different vertices.
  void requireDistinct(const SeamPath& path) const
  {
    for (std::size_t j = path.Begin; j < path.End; ++j)
    {
      const auto begin = this->Points.Vertices.begin() + static_cast<std::ptrdiff_t>(path.Begin);
      const auto first = std::find(begin, this->Points.Vertices.end(), this->Points.Vertices[j]);
      const auto i = static_cast<std::size_t>(first - this->Points.Vertices.begin());
      if (i + 1 == j)
      {
        throw InvalidInput(coincidence(i, j));
      }
      if (i < j)
      {
        throw TopologyError("the seam comes back to its point " + std::to_string(i + 1) +
                            ": a seam must not be closed or cross itself; leave the point " +
                            std::to_string(j + 1) + " out");
      }
    }
  }

  static std::string coincidence(std::size_t i, std::size_t j)
  {
    return "points " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
           " of the seam coincide: a seam needs two points or more, apart from each other";
  }

  // Moves the first point of a path onto the boundary if it is near to it, and the last one if it is
  // near to a loop on which the path does not start.
  void endOnBoundary(const SeamPath& path, std::vector<SurfacePoint>& picked)
  {
    int taken = -1;
    for (const std::size_t i : { path.Begin, path.End - 1 })
    {
      int loop = -1;
      const SurfacePoint nearest = this->nearestOnBoundary(picked[i].Position, loop);
      if (loop != taken && (nearest.Position - picked[i].Position).norm() <=
                             this->Surface.longestEdge(Face(picked[i].Face)))
      {
        picked[i] = nearest;
        this->Points.OnBoundary.push_back(i);
        taken = loop;
      }
    }
  }

  // The nearest vertex of the boundary.
  SurfacePoint nearestOnBoundary(const Eigen::Vector3d& position, int& loopNumber) const
  {
    int nearest = -1;
    double distance = HUGE_VAL;
    for (std::size_t k = 0; k < this->Topology.BoundaryLoops.size(); ++k)
    {
      for (const int v : this->Topology.BoundaryLoops[k])
      {
        const double d = (this->Original.Vertices.row(v).transpose() - position).squaredNorm();
        if (d < distance)
        {
          distance = d;
          nearest = v;
          loopNumber = static_cast<int>(k);
        }
      }
    }
    const Halfedge border =
      CGAL::is_border(Vertex(nearest), this->Surface.mesh()).value();
    const Face face = this->Surface.mesh().face(this->Surface.mesh().opposite(border));
    return cornerOf(this->Original, static_cast<int>(face.idx()), nearest);
  }

  EditableSurface& Surface;
  const TriangleMesh& Original;
  const MeshTopology& Topology;
  const GeodesicSeamOptions& Options;
  const std::size_t EdgesWanted;
  const double Diagonal;
  SeamWayPoints Points;
};

} // namespace

bool SeamWayPoints::isOnBoundary(std::size_t point) const
{
  return std::find(this->OnBoundary.begin(), this->OnBoundary.end(), point) != this->OnBoundary.end();
}

std::vector<std::size_t> SeamWayPoints::legs() const
{
  std::vector<std::size_t> legs;
  for (const SeamPath& path : this->Paths)
  {
    for (std::size_t i = path.Begin; i + 1 < path.End; ++i)
    {
      legs.push_back(i);
    }
  }
  return legs;
}

SeamWayPoints insertWayPoints(SeamInsertion& seams,
  const TriangleMesh& original,
  const MeshTopology& topology,
  const GeodesicSeamOptions& options,
  std::size_t edgesWanted,
  const ProgressCallback& progress)
{
  return WayPointInserter(seams.surface(), original, topology, options, edgesWanted).insert(progress);
}

} // namespace flattening
