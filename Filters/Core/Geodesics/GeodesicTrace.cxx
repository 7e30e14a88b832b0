// SPDX-License-Identifier: GPL-3.0-or-later
// The paths of a search, traced back from where it has arrived.
#include "Geodesics/GeodesicSearch.h"

#include "Mesh/Halfedges.h"
#include "Mesh/PlaneVectors.h"

#include <Eigen/Core>

#include <algorithm>
#include <map>
#include <utility>

namespace flattening
{
namespace
{

using Eigen::Vector2d;

// A straight line at a half-edge that it meets, and the point to which the line goes, in the plane of
// the half-edge.
struct LineAtHalfedge
{
  int Halfedge;
  double Position; // along the half-edge
  Vector2d Goal;
};

PathCrossing crossingOf(const UnfoldableFaces& faces, const LineAtHalfedge& line)
{
  const double length = faces.Sides[line.Halfedge].Length;
  if (!(line.Position > 0.0))
  {
    return { faces.Origin[line.Halfedge] };
  }
  if (!(line.Position < length))
  {
    return { faces.Origin[nextHalfedge(line.Halfedge)] };
  }
  return { -1, line.Halfedge, line.Position / length };
}

// The line at the side from @p begin to @p end, by which it leaves a face; all points are in its plane.
LineAtHalfedge leaveBy(int halfedge,
  const Vector2d& begin,
  const Vector2d& end,
  const Vector2d& from,
  const Vector2d& goal)
{
  const Vector2d side = end - begin;
  const double length = side.norm();
  const Vector2d along = length > 0.0 ? Vector2d(side / length) : Vector2d(1.0, 0.0);
  const Vector2d ahead = goal - from;
  const double scale = cross(ahead, along);
  const double position = scale != 0.0 ? cross(begin - from, ahead) / scale : 0.0;
  const Vector2d toGoal = goal - begin;
  return { halfedge,
    position > 0.0 ? std::min(position, length) : 0.0,
    { along.dot(toGoal), cross(along, toGoal) } };
}

// The line goes on over the face on the other side of its half-edge to another half-edge of that face.
LineAtHalfedge crossFace(const UnfoldableFaces& faces, const LineAtHalfedge& line, int next)
{
  const int below = faces.Opposite[line.Halfedge];
  const PlanarSide& side = faces.Sides[below];
  const Vector2d from(side.Length - line.Position, 0.0);
  const Vector2d goal(side.Length - line.Goal.x(), -line.Goal.y());
  const Vector2d apex(side.ApexX, side.ApexY);
  return next == nextHalfedge(below) ? leaveBy(next, { side.Length, 0.0 }, apex, from, goal)
                                     : leaveBy(next, apex, { 0.0, 0.0 }, from, goal);
}

// A line that passes a place by rounding may meet it, then half-edges beside it, and then the place
// again.
std::vector<PathCrossing> withoutLoops(const std::vector<PathCrossing>& path)
{
  std::vector<PathCrossing> result;
  std::map<std::pair<int, int>, std::size_t> first; // of each place or edge
  for (const PathCrossing& crossing : path)
  {
    const std::pair<int, int> key(crossing.Place, crossing.Halfedge);
    const auto [known, isNew] = first.try_emplace(key, result.size());
    if (isNew || known->second >= result.size() ||
        std::pair(result[known->second].Place, result[known->second].Halfedge) != key)
    {
      known->second = result.size();
      result.push_back(crossing);
    }
    else
    {
      result.resize(known->second + 1);
    }
  }
  return result;
}

} // namespace

void GeodesicSearch::appendLine(const Arrival& arrival, std::vector<PathCrossing>& path) const
{
  int trail = arrival.Trail;
  LineAtHalfedge line{ this->Trails[trail].Halfedge, arrival.Position, { arrival.X, arrival.Y } };
  for (;;)
  {
    const PathCrossing next = crossingOf(this->Faces, line);
    if (next.Place < 0 || next.Place != path.back().Place) // several half-edges may begin at a place
    {
      path.push_back(next);
    }
    trail = this->Trails[trail].Before;
    if (trail < 0)
    {
      return; // in the next face lies the place from which the line comes
    }
    line = crossFace(this->Faces, line, this->Trails[trail].Halfedge);
  }
}

std::vector<PathCrossing> GeodesicSearch::pathFrom(int target) const
{
  // Every place on the way is nearer to the source than the one before it, or as near and was reached
  // earlier: the loop ends.
  std::vector<PathCrossing> path{ { this->Faces.PlaceOf[target] } };
  for (int place = path.front().Place; this->Arrivals[place].Origin != place;)
  {
    const Arrival& arrival = this->Arrivals[place];
    if (arrival.Trail >= 0)
    {
      this->appendLine(arrival, path);
    }
    place = arrival.Origin;
    if (path.back().Place != place)
    {
      path.push_back({ place });
    }
  }
  return withoutLoops(path);
}

} // namespace flattening
