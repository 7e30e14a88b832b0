// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/FlatMapTransfer.h"

#include "Base/Errors.h"
#include "FlatMap/SeamBanks.h"
#include "FlatMap/SharedFaces.h"
#include "FlatMap/SurfaceBoundary.h"
#include "Mesh/ClosestPointWalk.h"
#include "Mesh/MeshMeasures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>

namespace flattening
{
namespace
{

// A vertex is beyond the boundary if it is farther from its place on the boundary, along the surface,
// than this share of the mean edge length. The value is between rounding and the size of a triangle;
// smaller ones lose boundary vertices, greater ones squeeze vertices beyond the boundary onto it.
constexpr double BeyondBoundary = 1e-6;

// The greatest number of rounds, in each of which places spread from vertices to their neighbours. A
// guard: the rounds end as soon as no vertex is found.
constexpr int GreatestRounds = 100;

// The number of vertices or faces between two reports of progress, at which an abort is noticed.
constexpr int Batch = 1 << 14;

constexpr const char* TransferStage = "Transferring the map";

void requireFits(const FlattenedSurface& flattened, const TriangleMesh& target, double tolerance)
{
  if (flattened.Positions.rows() != flattened.Surface.vertexCount())
  {
    throw InvalidInput("there are " + std::to_string(flattened.Positions.rows()) +
                       " flat positions for " + std::to_string(flattened.Surface.vertexCount()) +
                       " vertices: pass the positions of this very surface");
  }
  if (flattened.Surface.faceCount() == 0 || target.faceCount() == 0)
  {
    throw InvalidInput("a surface has no triangles: pass a flattened and an original surface");
  }
  if (!flattened.Surface.Vertices.allFinite() || !flattened.Positions.allFinite())
  {
    throw InvalidInput("the flattened surface has a coordinate that is not finite: flatten it again");
  }
  if (!target.Vertices.allFinite())
  {
    throw InvalidInput("the original surface has a coordinate that is not finite: remove such points "
                       "first, e.g. with Threshold or Extract Selection");
  }
  if (!(tolerance >= 0.0) || !std::isfinite(tolerance))
  {
    throw InvalidInput("the tolerance is " + formatted(tolerance) +
                       ": set it to 0, for half of the mean edge length, or to a length");
  }
}

class MapTransfer
{
public:
  MapTransfer(const FlattenedSurface& flattened, const TriangleMesh& target, TransferredMap& map)
    : Flattened(flattened)
    , Target(target)
    , Map(map)
    , Normals(vertexNormals(target))
    , Shared(sharedFaces(flattened.Surface, target))
    , Walk(flattened.Surface)
    , Boundary(flattened.Surface)
    , MeanEdge(meanEdgeLength(flattened.Surface))
  {
    map.Tolerance = map.Tolerance > 0.0 ? map.Tolerance : 0.5 * this->MeanEdge;
    map.Positions = Points2::Zero(target.vertexCount(), 2);
    map.Survived.assign(target.vertexCount(), 0);
    map.Places.assign(target.vertexCount(), { 0, Eigen::Vector3d::Zero(), { 1.0, 0.0, 0.0 } });
  }

  void projectAll(const ProgressCallback& progress);
  void keepSharedFaces();
  void walkFromNeighbours(const ProgressCallback& progress);
  void place();
  void placeTheFaces(const ProgressCallback& progress);

private:
  Eigen::Vector3d point(int v) const { return this->Target.Vertices.row(v); }
  bool accepts(int v, const SurfacePoint& at, SurfaceBoundary::Part end) const;
  bool isBeyondBoundary(int v, const SurfacePoint& at, SurfaceBoundary::Part end) const;

  const FlattenedSurface& Flattened;
  const TriangleMesh& Target;
  TransferredMap& Map;
  Points3 Normals;
  std::vector<SharedFace> Shared;
  ClosestPointWalk Walk;
  std::optional<ClosestPointTree> Tree;
  SurfaceBoundary Boundary;
  double MeanEdge;
};

// @param end the parts of the boundary, from this one on, at which the surface ends for the search: Seam
// for a walk, which does not cross a seam; Border for a search that has seen all banks.
bool MapTransfer::isBeyondBoundary(int v, const SurfacePoint& at, SurfaceBoundary::Part end) const
{
  const Eigen::Vector3d offset = this->point(v) - at.Position;
  const Eigen::Vector3d normal = this->Walk.normal(at);
  return this->Boundary.partAt(at) >= end &&
         (offset - normal.dot(offset) * normal).norm() > BeyondBoundary * this->MeanEdge;
}

bool MapTransfer::accepts(int v, const SurfacePoint& at, SurfaceBoundary::Part end) const
{
  return (at.Position - this->point(v)).norm() <= this->Map.Tolerance &&
         this->Normals.row(v).dot(this->Walk.normal(at)) > 0.0 && !this->isBeyondBoundary(v, at, end);
}

void MapTransfer::projectAll(const ProgressCallback& progress)
{
  this->Tree.emplace(this->Flattened.Surface, subrange(progress, 0.0, 0.4));
  const int vertexCount = this->Target.vertexCount();
  std::vector<double> agreement(vertexCount, 0.0);
  for (int begin = 0; begin < vertexCount; begin += Batch)
  {
    report(progress, 0.4 + 0.6 * begin / vertexCount, TransferStage);
    tbb::parallel_for(begin,
      std::min(begin + Batch, vertexCount),
      [&](int v)
      {
        SurfacePoint& at = this->Map.Places[v];
        at = this->Tree->closest(this->point(v));
        if ((at.Position - this->point(v)).norm() <= this->Map.Tolerance)
        {
          agreement[v] = this->Normals.row(v).dot(this->Walk.normal(at));
        }
      });
  }
  report(progress, 1.0, TransferStage);
  const double sum = std::accumulate(agreement.begin(), agreement.end(), 0.0);
  if (sum < 0.0) // the whole target is oriented the other way round
  {
    this->Normals = -this->Normals;
  }
  tbb::parallel_for(0,
    this->Target.vertexCount(),
    [this](int v)
    { this->Map.Survived[v] = this->accepts(v, this->Map.Places[v], SurfaceBoundary::Part::Border); });
}

// The corners of a face that the flattened surface has, too, are where it has them. The nearest place
// may be another, where the surface passes through itself.
void MapTransfer::keepSharedFaces()
{
  for (int f = this->Target.faceCount() - 1; f >= 0; --f)
  {
    for (int k = 0; k < 3 && this->Shared[f].Face >= 0; ++k)
    {
      const int v = this->Target.Faces(f, k);
      this->Map.Places[v] = cornerOf(this->Flattened.Surface, this->Shared[f], k);
      this->Map.Survived[v] = 1;
    }
  }
}

void MapTransfer::walkFromNeighbours(const ProgressCallback& progress)
{
  std::vector<char> open(this->Target.vertexCount(), 1); // their neighbours were not tried yet
  for (int round = 0; round < GreatestRounds; ++round)
  {
    std::vector<int> found;
    for (int f = 0; f < this->Target.faceCount(); ++f)
    {
      if (f % Batch == 0)
      {
        report(progress, static_cast<double>(round) / GreatestRounds, TransferStage);
      }
      for (int k = 0; k < 3; ++k)
      {
        const int lost = this->Target.Faces(f, k);
        for (const int near : { this->Target.Faces(f, (k + 1) % 3), this->Target.Faces(f, (k + 2) % 3) })
        {
          if (this->Map.Survived[lost] == 0 && this->Map.Survived[near] == 1 && open[near])
          {
            const SurfacePoint at = this->Walk.closest(this->point(lost), this->Map.Places[near].Face);
            if (this->accepts(lost, at, SurfaceBoundary::Part::Seam))
            {
              this->Map.Places[lost] = at;
              this->Map.Survived[lost] = 2; // so that the order within the round does not matter
              found.push_back(lost);
            }
          }
        }
      }
    }
    for (int v = 0; v < this->Target.vertexCount(); ++v)
    {
      open[v] = this->Map.Survived[v] == 2;
    }
    for (const int v : found)
    {
      this->Map.Survived[v] = 1;
    }
    if (found.empty())
    {
      return;
    }
  }
}

void MapTransfer::place()
{
  for (int v = 0; v < this->Target.vertexCount(); ++v)
  {
    if (this->Map.Survived[v])
    {
      const SurfacePoint& at = this->Map.Places[v];
      for (int k = 0; k < 3; ++k)
      {
        this->Map.Positions.row(v) +=
          at.Weights[k] * this->Flattened.Positions.row(this->Flattened.Surface.Faces(at.Face, k));
      }
      this->Map.LargestDistance =
        std::max(this->Map.LargestDistance, (at.Position - this->point(v)).norm());
    }
  }
}

void MapTransfer::placeTheFaces(const ProgressCallback& progress)
{
  const PlaceSearch search{
    *this->Tree, this->Walk, this->Boundary, this->Normals, this->Shared, BeyondBoundary * this->MeanEdge
  };
  placeFaces(this->Flattened, this->Target, search, this->Map, progress);
}

} // namespace

TransferredMap transferFlatMap(const FlattenedSurface& flattened,
  const TriangleMesh& target,
  double tolerance,
  const ProgressCallback& progress)
{
  requireFits(flattened, target, tolerance);
  TransferredMap map;
  map.Tolerance = tolerance;
  report(progress, 0.0, TransferStage);
  MapTransfer transfer(flattened, target, map);
  transfer.projectAll(subrange(progress, 0.2, 0.6));
  transfer.keepSharedFaces();
  transfer.walkFromNeighbours(subrange(progress, 0.6, 0.9));
  if (std::find(map.Survived.begin(), map.Survived.end(), 1) == map.Survived.end())
  {
    std::ostringstream message;
    message << "no point of the original surface lies within " << map.Tolerance
            << " of the flattened one: pass the surface that the flattened one was made from, or raise "
               "the tolerance";
    throw InvalidInput(message.str());
  }
  report(progress, 0.9, TransferStage);
  transfer.place();
  transfer.placeTheFaces(subrange(progress, 0.9, 1.0));
  report(progress, 1.0, TransferStage);
  return map;
}

} // namespace flattening
