// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/ReliefCut.h"

#include "Base/Errors.h"
#include "Disk/PathInsertion.h"
#include "Geodesics/DijkstraDistance.h"
#include "Geodesics/GeodesicPath.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

using Vertex = EditableSurface::Vertex;

// The distance of the branches from the region to be avoided, where there is room, in square roots of
// the surface's area: half of that which the tips keep on the coarse copy (ReliefPlacement.cxx), whose
// edges are about as long.
constexpr double BranchClearance = 0.01;

// Branches shorter than this are not cut, in square roots of the surface's area: an edge of the coarse
// copy. A shorter one is where a branch before it came nearer to the tip on the surface than on the
// copy, so that the tip is reached as well as the copy can tell.
constexpr double ShortestBranch = 0.02;

constexpr const char* CuttingStage = "Cutting the relief";

class ReliefCutter
{
public:
  ReliefCutter(const TriangleMesh& mesh, const std::vector<char>& avoided)
    : Original(mesh)
    , Unit(std::sqrt(faceAreas(mesh.Vertices, mesh.Faces).sum()))
    , Topology(analyseTopology(mesh.Faces, mesh.vertexCount()))
    , Seams(mesh, Topology)
  {
    if (!avoided.empty())
    {
      const Eigen::VectorXd distance = distancesFromFlagged(this->Seams.mesh(), avoided);
      for (const double clearance : { BranchClearance * this->Unit, 0.0 })
      {
        const auto isNear = (distance.array() <= clearance).cast<char>();
        this->BlockedOriginals.emplace_back(isNear.begin(), isNear.end());
      }
    }
    else
    {
      this->BlockedOriginals.emplace_back();
    }
  }

  ReliefOpenedSurface cut(const std::vector<Eigen::Vector3d>& tips, const ProgressCallback& progress)
  {
    ReliefOpenedSurface relief;
    std::vector<Vertex> vertices;
    for (const Eigen::Vector3d& tip : tips)
    {
      vertices.push_back(this->nearestVertex(tip));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const double done = static_cast<double>(i) / static_cast<double>(vertices.size());
      report(progress, done, CuttingStage);
      if (this->Seams.partCount() == 0)
      {
        this->Seams.take(vertices[i]);
      }
      else if (!this->Seams.isTaken(vertices[i]))
      {
        relief.Branches +=
          this->addBranch(vertices[i], atFraction(progress, done, CuttingStage)) ? 1 : 0;
      }
    }
    relief.Opened = this->Seams.cut();
    report(progress, 1.0, CuttingStage);
    return relief;
  }

private:
  const SurfaceMesh& mesh() const { return this->Seams.mesh(); }

  // Distances are compared in single precision, so that of vertices as near the first one is chosen.
  Vertex nearestVertex(const Eigen::Vector3d& point) const
  {
    const Eigen::VectorXd squares =
      (this->Original.Vertices.rowwise() - point.transpose()).rowwise().squaredNorm();
    return Vertex(indexOfLargest(-squares));
  }

  // Joins the tip to what is taken. Returns whether a free path leads there that is not too short.
  bool addBranch(Vertex tip, const ProgressCallback& progress)
  {
    for (const std::vector<char>& blocked : this->BlockedOriginals)
    {
      this->block(blocked);
      const NearestTarget end = nearestTarget(
        this->mesh(), tip, [this](Vertex v) { return this->Seams.isTaken(v); }, this->Blocked);
      if (end.Vertex.is_valid() && this->isOpen() &&
          end.Distances[end.Vertex] < ShortestBranch * this->Unit)
      {
        return false;
      }
      if (end.Vertex.is_valid())
      {
        const std::vector<int> path = shortestPath(this->mesh(), end.Distances, end.Vertex);
        this->follow(path, 0, path.size() - 1, progress);
        return true;
      }
    }
    return false;
  }

  // Vertices on edges of the original are blocked if one of the ends is. Without flags none is.
  void block(const std::vector<char>& original)
  {
    if (original.empty())
    {
      return;
    }
    this->Blocked.assign(this->mesh().num_vertices(), 0);
    for (const Vertex v : this->mesh().vertices())
    {
      for (const auto& [origin, weight] : this->Seams.surface().origin(v))
      {
        this->Blocked[v] |= original[origin];
      }
    }
  }

  // Joins vertex path[to] with path[from], which is taken, by a geodesic, or by several one after the
  // other if a single one would leave the free vertices.
  void follow(const std::vector<int>& path,
    std::size_t from,
    std::size_t to,
    const ProgressCallback& progress)
  {
    if (this->Seams.isTaken(Vertex(path[to])))
    {
      return;
    }
    const std::vector<Vertex> near(path.begin() + from, path.begin() + to + 1);
    std::vector<PathPoint> leg =
      geodesicPath(this->mesh(), Vertex(path[to]), Vertex(path[from]), progress, near).Points;
    this->endAtTaken(leg);
    if (to - from > 1 &&
        std::any_of(leg.begin(), leg.end(), [this](const PathPoint& p) { return this->isBlocked(p); }))
    {
      const std::size_t middle = (from + to) / 2;
      this->follow(path, from, middle, progress);
      this->follow(path, middle, to, progress);
      return;
    }
    snapToVertices(
      this->mesh(), leg, [this](Vertex v) { return this->Seams.isTaken(v) || this->isBlocked(v); });
    if (leg.size() == 2 && !this->isOpen())
    {
      // A cut of a single edge would not open the surface.
      leg.insert(leg.begin() + 1,
        PathPoint{ {}, this->mesh().halfedge(leg.front().Vertex, leg.back().Vertex), 0.5 });
    }
    this->Seams.insert(leg);
  }

  // Shortens a path to the first place where it meets what is taken, and moves that to a vertex.
  void endAtTaken(std::vector<PathPoint>& path) const
  {
    const auto meets = [this](const PathPoint& point)
    { return this->Seams.isOnBoundary(point) || this->Seams.isOnSeam(point); };
    const auto end = std::find_if(path.begin() + 1, path.end(), meets);
    if (end == path.end())
    {
      return;
    }
    if (!end->isVertex())
    {
      const Vertex near =
        end->Fraction < 0.5 ? this->mesh().source(end->Edge) : this->mesh().target(end->Edge);
      *end = { near, SurfaceMesh::null_halfedge(), 0.0 };
    }
    path.erase(end + 1, path.end());
  }

  bool isBlocked(Vertex v) const { return v.idx() < this->Blocked.size() && this->Blocked[v]; }

  bool isBlocked(const PathPoint& point) const
  {
    return point.isVertex() ? this->isBlocked(point.Vertex)
                            : this->isBlocked(this->mesh().source(point.Edge)) ||
                                this->isBlocked(this->mesh().target(point.Edge));
  }

  bool isOpen() const { return this->Seams.edgeCount() > 0 || !this->Topology.BoundaryLoops.empty(); }

  const TriangleMesh& Original;
  const double Unit; // the square root of the area
  const MeshTopology Topology;
  SeamInsertion Seams;
  // Flags of the original vertices that branches may not touch: with a clearance, and without.
  std::vector<std::vector<char>> BlockedOriginals;
  std::vector<char> Blocked; // the same of the vertices of the mesh as it is, for the present branch
};

} // namespace

ReliefOpenedSurface cutRelief(const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& tips,
  const std::vector<char>& avoided,
  const ProgressCallback& progress)
{
  return ReliefCutter(mesh, avoided).cut(tips, progress);
}

} // namespace flattening
