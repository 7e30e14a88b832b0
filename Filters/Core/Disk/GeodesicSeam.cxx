// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/GeodesicSeam.h"

#include "Base/Errors.h"
#include "Disk/PathInsertion.h"
#include "Geodesics/GeodesicPath.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfacePick.h"
#include "Remeshing/EdgeFlips.h"
#include "Remeshing/LongestEdgeBisection.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Vertex = EditableSurface::Vertex;
using Halfedge = EditableSurface::Halfedge;
using Face = EditableSurface::Face;

// The factor on the edge length wanted if the seam still crosses too few edges. A convention: between 0
// and 1, small factors overshoot and factors near 1 need many rounds.
constexpr double SeamRefinement = 0.7;
constexpr int MostSeamRounds = 30; // a guard: as many halvings take edges to a billionth
// The least distance of consecutive points, as a share of the surface's diagonal. A guard: refinement
// between closer points would go down to rounding.
constexpr double SmallestStep = 1e-6;

SurfacePoint cornerOf(const TriangleMesh& mesh, int face, int vertex)
{
  SurfacePoint point{ face, mesh.Vertices.row(vertex), { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    point.Weights[k] = mesh.Faces(face, k) == vertex ? 1.0 : 0.0;
  }
  return point;
}

class SeamCutter
{
public:
  SeamCutter(const TriangleMesh& mesh, const GeodesicSeamOptions& options, const MeshTopology& topology)
    : Original(mesh)
    , Options(options)
    , Topology(topology)
    , Surface(mesh)
    , Mesh(this->Surface.mesh())
  {
  }

  SeamOpenedSurface cut(const ProgressCallback& progress)
  {
    report(progress, 0.0, "placing the seam");
    this->placePoints();
    this->refineAlongSeam(subrange(progress, 0.1, 0.5));
    this->insertSeam(subrange(progress, 0.5, 0.9));
    flipInsideOriginalFaces(this->Surface, this->Seam);

    report(progress, 0.9, "cutting along the seam");
    SeamOpenedSurface opened;
    for (const Vertex v : this->WayPoints)
    {
      const Kernel::Point_3& p = this->Mesh.point(v);
      opened.Points.emplace_back(p.x(), p.y(), p.z());
    }
    std::vector<MeshEdge> edges;
    for (std::size_t i = 0; i + 1 < this->Seam.size(); ++i)
    {
      const Vertex from = this->Seam[i];
      const Vertex to = this->Seam[i + 1];
      edges.push_back({ static_cast<int>(from.idx()), static_cast<int>(to.idx()) });
      opened.Length += std::sqrt(this->Surface.squaredLength(this->Mesh.halfedge(from, to)));
    }
    DerivedMesh whole = this->Surface.derived();
    opened.Cut = cutAlongEdges(whole.Mesh, edges);
    follow(whole, std::move(opened.Cut.Surface));
    opened.Cut.Surface = std::move(whole);
    return opened;
  }

private:
  // The number of edges of the seam with which the boundary has the vertices asked for.
  std::size_t edgesWanted() const
  {
    std::size_t boundary = 0;
    for (const std::vector<int>& loop : this->Topology.BoundaryLoops)
    {
      boundary += loop.size();
    }
    const auto wanted = static_cast<std::size_t>(this->Options.BoundaryVertices);
    return std::max<std::size_t>(2, wanted > boundary ? (wanted - boundary + 1) / 2 : 0);
  }

  // Makes the points vertices, in faces small enough for a seam with enough edges.
  void placePoints()
  {
    const ClosestPointTree projection(this->Original);
    std::vector<SurfacePoint> picked;
    for (std::size_t i = 0; i < this->Options.Points.size(); ++i)
    {
      picked.push_back(pickOnSurface(this->Original,
        projection,
        this->Options.Points[i],
        "point " + std::to_string(i + 1) + " of the seam"));
    }
    if (!this->Topology.BoundaryLoops.empty())
    {
      this->startOnBoundary(picked);
    }
    const double diagonal =
      (this->Original.Vertices.colwise().maxCoeff() - this->Original.Vertices.colwise().minCoeff())
        .norm();
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < picked.size(); ++i)
    {
      const double step = (picked[i + 1].Position - picked[i].Position).norm();
      if (!(step > SmallestStep * diagonal))
      {
        throw InvalidInput(this->coincidence(i, i + 1));
      }
      length += step;
    }
    for (const SurfacePoint& point : picked)
    {
      this->WayPoints.push_back(
        insertPoint(this->Surface, point, length / static_cast<double>(this->edgesWanted())));
    }
    for (std::size_t j = 0; j < picked.size(); ++j)
    {
      const auto first = std::find(this->WayPoints.begin(), this->WayPoints.end(), this->WayPoints[j]);
      const auto i = static_cast<std::size_t>(first - this->WayPoints.begin());
      if (i + 1 == j)
      {
        throw InvalidInput(this->coincidence(i, j));
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

  // Moves the first point onto the boundary if it is near to it, and the last one if it is near to a
  // loop on which the seam does not start.
  void startOnBoundary(std::vector<SurfacePoint>& picked)
  {
    int taken = -1;
    for (const std::size_t i : { std::size_t(0), picked.size() - 1 })
    {
      int loop = -1;
      const SurfacePoint nearest = this->nearestOnBoundary(picked[i].Position, loop);
      if (loop != taken && (nearest.Position - picked[i].Position).norm() <=
                             this->Surface.longestEdge(Face(picked[i].Face)))
      {
        picked[i] = nearest;
        this->BoundaryPoints.push_back(i);
        taken = loop;
      }
    }
    if (this->BoundaryPoints.empty())
    {
      throw TopologyError(
        "the surface has a boundary, and the seam neither starts nor ends on it: put its "
        "first or last point onto the boundary, or flatten the surface as it is");
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
    const Halfedge border = this->Mesh.halfedge(Vertex(nearest)); // Surface_mesh keeps a border one here
    const Face face = this->Mesh.face(this->Mesh.opposite(border));
    return cornerOf(this->Original, static_cast<int>(face.idx()), nearest);
  }

  // Refines the mesh until the geodesics cross enough edges.
  void refineAlongSeam(const ProgressCallback& progress)
  {
    double refinement = 1.0;
    for (int round = 0; round < MostSeamRounds; ++round)
    {
      std::vector<Face> faces;
      double length = 0.0;
      std::size_t edges = 0;
      for (std::size_t i = 0; i + 1 < this->WayPoints.size(); ++i)
      {
        GeodesicPath path = geodesicPath(this->Mesh,
          this->WayPoints[i],
          this->WayPoints[i + 1],
          subrange(progress, round > 0 ? 1.0 : 0.0, 1.0));
        length += path.Length;
        this->FirstLeg = i == 0 ? path.Points : this->FirstLeg;
        snapToVertices(this->Mesh, path.Points, [this](Vertex v) { return this->Mesh.is_border(v); });
        edges += path.Points.size() - 1;
        if (edges >= this->edgesWanted())
        {
          return;
        }
        this->addFaces(path.Points, faces);
      }
      const double wanted = refinement * length / static_cast<double>(this->edgesWanted());
      const bool isCoarse = halveLongEdges(this->Surface, faces, wanted) > wanted;
      refinement *= isCoarse ? 1.0 : SeamRefinement;
    }
    throw TopologyError("the seam crosses too few edges of the surface, however it is refined: remesh "
                        "the surface");
  }

  void addFaces(const std::vector<PathPoint>& path, std::vector<Face>& faces) const
  {
    for (const PathPoint& point : path)
    {
      if (point.isVertex())
      {
        for (const Face face : this->Mesh.faces_around_target(this->Mesh.halfedge(point.Vertex)))
        {
          faces.push_back(face);
        }
      }
      else
      {
        faces.push_back(this->Mesh.face(point.Edge));
        faces.push_back(this->Mesh.face(this->Mesh.opposite(point.Edge)));
      }
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    faces.erase(std::remove(faces.begin(), faces.end(), SurfaceMesh::null_face()), faces.end());
  }

  void insertSeam(const ProgressCallback& progress)
  {
    this->Seam = { this->WayPoints.front() };
    for (std::size_t leg = 0; leg + 1 < this->WayPoints.size(); ++leg)
    {
      const double legs = static_cast<double>(this->WayPoints.size() - 1);
      const double done = static_cast<double>(leg);
      // Inserting one leg changes the mesh for the next one.
      std::vector<PathPoint> path = leg == 0 ? this->FirstLeg
                                             : geodesicPath(this->Mesh,
                                                 this->WayPoints[leg],
                                                 this->WayPoints[leg + 1],
                                                 subrange(progress, done / legs, (done + 1.0) / legs))
                                                 .Points;
      this->NumberInSeam.assign(this->Mesh.num_vertices(), -1);
      for (std::size_t i = 0; i < this->Seam.size(); ++i)
      {
        this->NumberInSeam[this->Seam[i]] = static_cast<int>(i);
      }
      snapToVertices(this->Mesh,
        path,
        [this](Vertex v) { return this->Mesh.is_border(v) || this->NumberInSeam[v] >= 0; });
      this->requireFree(path, leg);
      const std::vector<Vertex> vertices = insertPath(this->Surface, path);
      this->Seam.insert(this->Seam.end(), vertices.begin() + 1, vertices.end());
    }
  }

  // Checks that a leg meets earlier legs only at its start, and the boundary only where the seam begins
  // or ends.
  void requireFree(const std::vector<PathPoint>& path, std::size_t leg) const
  {
    const std::string between =
      "between its points " + std::to_string(leg + 1) + " and " + std::to_string(leg + 2);
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      const std::size_t wayPoint = i == 0 ? leg : leg + 1;
      const bool isWayPoint = i == 0 || i + 1 == path.size();
      if (this->isOnBoundary(path[i]) && !(isWayPoint && this->isBoundaryPoint(wayPoint)))
      {
        throw TopologyError("the seam touches the boundary " + between +
                            ": only its first or last point may lie on the boundary; lead it past with "
                            "points in between");
      }
      if (i > 0 && this->isOnSeam(path[i]))
      {
        throw TopologyError("the seam crosses or touches itself " + between +
                            ": put its points into the order along the seam, or lead it past with "
                            "points in between");
      }
    }
  }

  bool isBoundaryPoint(std::size_t wayPoint) const
  {
    return std::find(this->BoundaryPoints.begin(), this->BoundaryPoints.end(), wayPoint) !=
           this->BoundaryPoints.end();
  }

  bool isOnBoundary(const PathPoint& point) const
  {
    return point.isVertex() ? this->Mesh.is_border(point.Vertex)
                            : this->Mesh.is_border(this->Mesh.edge(point.Edge));
  }

  bool isOnSeam(const PathPoint& point) const
  {
    if (point.isVertex())
    {
      return this->NumberInSeam[point.Vertex] >= 0;
    }
    const int source = this->NumberInSeam[this->Mesh.source(point.Edge)];
    const int target = this->NumberInSeam[this->Mesh.target(point.Edge)];
    return source >= 0 && target >= 0 && std::abs(source - target) == 1;
  }

  const TriangleMesh& Original;
  const GeodesicSeamOptions& Options;
  const MeshTopology& Topology;
  EditableSurface Surface;
  SurfaceMesh& Mesh;
  std::vector<Vertex> WayPoints;
  std::vector<std::size_t> BoundaryPoints; // numbers of the way points on the boundary: one or both ends
  std::vector<PathPoint> FirstLeg;
  std::vector<Vertex> Seam;
  std::vector<int> NumberInSeam; // per vertex: its position along the seam, or -1
};

} // namespace

SeamOpenedSurface cutGeodesicSeam(const TriangleMesh& mesh,
  const GeodesicSeamOptions& options,
  const ProgressCallback& progress)
{
  if (options.Points.size() < 2)
  {
    throw InvalidInput("a seam through " + std::to_string(options.Points.size()) +
                       (options.Points.size() == 1 ? " point" : " points") +
                       " was asked for: it needs two points or more, apart from each other");
  }
  if (options.BoundaryVertices < 3)
  {
    throw InvalidInput("a boundary of " + std::to_string(options.BoundaryVertices) +
                       " vertices was asked for: ask for 3 at least");
  }
  const MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
  if (topology.Components != 1)
  {
    throw TopologyError("a seam opens one connected surface; this one has " +
                        std::to_string(topology.Components) + " components: run Surface To Disk");
  }
  return SeamCutter(mesh, options, topology).cut(progress);
}

} // namespace flattening
