// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/GeodesicSeam.h"

#include "Base/Errors.h"
#include "Disk/PathInsertion.h"
#include "Geodesics/GeodesicPath.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/LongestEdgeBisection.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Vertex = EditableSurface::Vertex;
using Face = EditableSurface::Face;

// The factor on the edge length wanted if the seam still crosses too few edges. A convention: between 0
// and 1, small factors overshoot and factors near 1 need many rounds.
constexpr double SeamRefinement = 0.7;
constexpr int MostSeamRounds = 30; // a guard: as many halvings take edges to a billionth

class SeamCutter
{
public:
  SeamCutter(const TriangleMesh& mesh, const GeodesicSeamOptions& options, const MeshTopology& topology)
    : Original(mesh)
    , Options(options)
    , Topology(topology)
    , Seams(mesh, topology)
    , Mesh(Seams.mesh())
  {
  }

  SeamOpenedSurface cut(const ProgressCallback& progress)
  {
    report(progress, 0.0, "placing the seam");
    this->Points = insertWayPoints(this->Seams,
      this->Original,
      this->Topology,
      this->Options,
      this->edgesWanted(),
      subrange(progress, 0.0, 0.1));
    this->refineAlongSeam(subrange(progress, 0.1, 0.5));
    for (const SeamPath& path : this->Points.Paths)
    {
      this->insertPath(path, subrange(progress, 0.5, 0.9));
    }
    this->requireOneTree();

    report(progress, 0.9, "cutting along the seam");
    SeamOpenedSurface opened = this->Seams.cut();
    for (const Vertex v : this->Points.Vertices)
    {
      const Kernel::Point_3& p = this->Mesh.point(v);
      opened.Points.emplace_back(p.x(), p.y(), p.z());
    }
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

  // Refines the mesh until the geodesics cross enough edges.
  void refineAlongSeam(const ProgressCallback& progress)
  {
    double refinement = 1.0;
    // Each leg is sought near where it was, as another geodesic that is as short would not be refined
    // yet.
    std::vector<std::vector<Vertex>> near(this->Points.Vertices.size());
    for (int round = 0; round < MostSeamRounds; ++round)
    {
      std::vector<Face> faces;
      double length = 0.0;
      std::size_t edges = 0;
      for (const std::size_t i : this->Points.legs())
      {
        GeodesicPath path = geodesicPath(this->Mesh,
          this->Points.Vertices[i],
          this->Points.Vertices[i + 1],
          subrange(progress, round > 0 ? 1.0 : 0.0, 1.0),
          near[i]);
        near[i] = verticesAlong(this->Mesh, path.Points);
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
      const bool isCoarse = halveLongEdges(this->Seams.surface(), faces, wanted) > wanted;
      refinement *= isCoarse ? 1.0 : SeamRefinement;
    }
    throw TopologyError("the seam crosses too few edges of the surface, however it is refined: lower "
                        "Minimum Boundary Vertices, or remesh the surface");
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

  // Inserts the legs of one path.
  void insertPath(const SeamPath& path, const ProgressCallback& progress)
  {
    if (path.Begin > 0)
    {
      this->endOnSeam(path.Begin, path.Begin + 1);
    }
    for (std::size_t leg = path.Begin; leg + 1 < path.End; ++leg)
    {
      if (path.Begin > 0 && leg + 2 == path.End)
      {
        this->endOnSeam(leg + 1, leg);
      }
      const double legs = static_cast<double>(this->Points.Vertices.size() - 1);
      const double done = static_cast<double>(leg);
      // Inserting one leg changes the mesh for the next one.
      std::vector<PathPoint> points = leg == 0 ? this->FirstLeg
                                               : geodesicPath(this->Mesh,
                                                   this->Points.Vertices[leg],
                                                   this->Points.Vertices[leg + 1],
                                                   subrange(progress, done / legs, (done + 1.0) / legs))
                                                   .Points;
      snapToVertices(this->Mesh,
        points,
        [this](Vertex v) { return this->Mesh.is_border(v) || this->Seams.isTaken(v); });
      this->requireFree(points, leg);
      if (this->Seams.areJoined(this->Points.Vertices[leg], this->Points.Vertices[leg + 1]))
      {
        throw TopologyError(crossing(leg));
      }
      this->Seams.insert(points);
    }
  }

  // Moves the end of a path onto a seam that is not farther than the edges there, unless that would
  // close a loop with the seams at @p next, the point before or after it.
  void endOnSeam(std::size_t end, std::size_t next)
  {
    const Vertex v = this->Points.Vertices[end];
    if (this->Seams.isTaken(v))
    {
      return;
    }
    double distance = 0.0;
    for (const Face face : this->Mesh.faces_around_target(this->Mesh.halfedge(v)))
    {
      distance = std::max(distance, this->Seams.surface().longestEdge(face));
    }
    Vertex nearest = v;
    for (const Vertex other : this->Mesh.vertices())
    {
      const double d = std::sqrt(CGAL::squared_distance(this->Mesh.point(v), this->Mesh.point(other)));
      if (d <= distance && this->Seams.isTaken(other) && !this->Mesh.is_border(other) &&
          !this->Seams.areJoined(other, this->Points.Vertices[next]))
      {
        distance = d;
        nearest = other;
      }
    }
    this->Points.Vertices[end] = nearest;
  }

  static std::string crossing(std::size_t leg)
  {
    return "the seam crosses or touches itself, or closes a loop, between its points " +
           std::to_string(leg + 1) + " and " + std::to_string(leg + 2) +
           ": put its points into the order along the seam, lead it past with points in between, or let "
           "a path begin on another one";
  }

  // Checks that a leg meets earlier legs only at its ends, and the boundary only where the seam begins
  // or ends.
  void requireFree(const std::vector<PathPoint>& path, std::size_t leg) const
  {
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      const std::size_t wayPoint = i == 0 ? leg : leg + 1;
      const bool isWayPoint = i == 0 || i + 1 == path.size();
      if (this->Seams.isOnBoundary(path[i]) && !(isWayPoint && this->Points.isOnBoundary(wayPoint)))
      {
        throw TopologyError("the seam touches the boundary between its points " +
                            std::to_string(leg + 1) + " and " + std::to_string(leg + 2) +
                            ": only its first or last point may lie on the boundary; lead it past with "
                            "points in between");
      }
      if (!isWayPoint && this->Seams.isOnSeam(path[i]))
      {
        throw TopologyError(crossing(leg));
      }
    }
  }

  // Checks that the cut leaves one boundary more at most: all paths of a closed surface meet, and each
  // path of an open one leads to the boundary.
  void requireOneTree() const
  {
    for (std::size_t k = 0; k < this->Points.Paths.size(); ++k)
    {
      const Vertex v = this->Points.Vertices[this->Points.Paths[k].Begin];
      const auto joins = [&](const std::vector<int>& loop)
      { return this->Seams.areJoined(v, Vertex(static_cast<SurfaceMesh::size_type>(loop.front()))); };
      const auto& loops = this->Topology.BoundaryLoops;
      if (loops.empty() ? !this->Seams.areJoined(v, this->Points.Vertices.front())
                        : std::none_of(loops.begin(), loops.end(), joins))
      {
        throw TopologyError("path " + std::to_string(k + 1) + " of the seam does not meet " +
                            (loops.empty() ? "the others" : "the boundary or the others") +
                            ": let it begin or end on a path before it");
      }
    }
  }

  const TriangleMesh& Original;
  const GeodesicSeamOptions& Options;
  const MeshTopology& Topology;
  SeamInsertion Seams;
  const SurfaceMesh& Mesh;
  SeamWayPoints Points;
  std::vector<PathPoint> FirstLeg;
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
