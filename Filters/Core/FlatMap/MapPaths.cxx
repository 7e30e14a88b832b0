// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/MapPaths.h"

#include "FlatMap/FlatMapLocation.h"
#include "Mesh/Halfedges.h"

#include <cmath>

namespace flattening
{
namespace
{

// A turn of the outline to the wrong side by less than this (radians) is rounding: the points on the
// straight side of a rectangle are no exact line. Straight lines are then too short by its square.
constexpr double RoundingOfTurn = 1e-9;

// The vertex after each vertex of the boundary; -1 inside. Empty if the boundary meets itself.
std::vector<int> nextOnBoundary(const UnfoldableFaces& faces, int vertexCount)
{
  std::vector<int> next(vertexCount, -1);
  for (int h = 0; h < faces.halfedgeCount(); ++h)
  {
    if (faces.Opposite[h] < 0)
    {
      if (next[faces.Origin[h]] >= 0)
      {
        return {};
      }
      next[faces.Origin[h]] = faces.Origin[nextHalfedge(h)];
    }
  }
  return next;
}

bool hasConvexOutline(const UnfoldableFaces& faces, const Points2& flat)
{
  const std::vector<int> next = nextOnBoundary(faces, static_cast<int>(flat.rows()));
  int start = -1;
  int length = 0;
  for (int v = 0; v < static_cast<int>(next.size()); ++v)
  {
    if (next[v] >= 0)
    {
      start = v;
      ++length;
    }
  }
  if (start < 0)
  {
    return false;
  }
  double least = 0.0;
  double greatest = 0.0;
  double sum = 0.0;
  int v = start;
  do
  {
    const int w = next[v];
    if (w < 0 || next[w] < 0)
    {
      return false;
    }
    const Eigen::RowVector2d before = flat.row(w) - flat.row(v);
    const Eigen::RowVector2d after = flat.row(next[w]) - flat.row(w);
    const double turn = std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
    least = std::min(least, turn);
    greatest = std::max(greatest, turn);
    sum += turn;
    --length;
    v = w;
  } while (v != start);
  const bool oneLoop = length == 0;
  const bool turnsOnce = std::abs(std::abs(sum) - 2.0 * EIGEN_PI) < 1.0;
  return oneLoop && turnsOnce && (least > -RoundingOfTurn || greatest < RoundingOfTurn);
}

} // namespace

MapPaper::MapPaper(const FaceMatrix& faces, const Points2& flat)
  : Flat(flat)
  , Faces(planarMesh(flat, faces), Seams::Open)
  , Convex(hasConvexOutline(this->Faces, flat))
{
}

MapPathSearch::MapPathSearch(const MapPaper& paper)
  : Paper(paper)
{
  if (!paper.isConvex())
  {
    this->Search = std::make_unique<GeodesicSearch>(paper.Faces);
  }
}

std::vector<double> MapPathSearch::to(const std::vector<int>& targets,
  int source,
  const GeodesicSearch::Checkpoint& checkpoint)
{
  if (this->Search)
  {
    return this->Search->to(targets, source, checkpoint);
  }
  std::vector<double> distances;
  distances.reserve(targets.size());
  for (const int target : targets)
  {
    distances.push_back((this->Paper.Flat.row(target) - this->Paper.Flat.row(source)).norm());
  }
  return distances;
}

} // namespace flattening
