// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/GeodesicSearch.h"

#include "Mesh/Halfedges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

// Windows that are narrower than this share of their edge are dropped: they are rounding errors. The
// places that they would reach are reached past the ends of their neighbours, by paths that are longer
// by the square of this share.
constexpr double NarrowestWindow = 1e-12;
// A bucket is sorted once it has taken up a window for every so many half-edges of the surface. A
// compromise: with 1, a surface whose few long edges make the buckets wide takes a third longer; if all
// buckets were sorted, half a brain would take 1.75 times as long.
constexpr int HalfedgesPerUnsortedWindow = 4;
// Windows and places from one call of the checkpoint to the next: a choice, some thousandths of a
// second. Around a vertex with hundreds of edges one bucket may have millions of windows.
constexpr int StepsPerCheckpoint = 1 << 12;

} // namespace

GeodesicSearch::GeodesicSearch(const UnfoldableFaces& faces, Paths paths)
  : Faces(faces)
  , KeptPaths(paths)
  , Width(faces.MeanLength)
  , Distances(faces.placeCount(), Infinite)
  , Arrivals(faces.placeCount())
  , Views(faces.halfedgeCount(), { Infinite, 0.0 })
{
}

std::vector<ReachedVertex> GeodesicSearch::within(double limit, int source, const Checkpoint& checkpoint)
{
  this->start(source, limit);
  while (this->advance(checkpoint))
  {
  }
  std::vector<ReachedVertex> reached;
  for (int v = 0; v < static_cast<int>(this->Faces.PlaceOf.size()); ++v)
  {
    const double distance = this->Distances[this->Faces.PlaceOf[v]];
    if (distance < Infinite && distance <= limit)
    {
      reached.push_back({ v, distance });
    }
  }
  return reached;
}

std::vector<double> GeodesicSearch::to(const std::vector<int>& targets,
  int source,
  const Checkpoint& checkpoint)
{
  this->start(source, Infinite);
  const auto distanceOf = [this](int target) { return this->Distances[this->Faces.PlaceOf[target]]; };
  const auto isFinal = [this, &distanceOf](int target)
  { return distanceOf(target) <= this->Width * static_cast<double>(this->Current); };
  while (!std::all_of(targets.begin(), targets.end(), isFinal) && this->advance(checkpoint))
  {
  }
  std::vector<double> distances(targets.size());
  std::transform(targets.begin(), targets.end(), distances.begin(), distanceOf);
  return distances;
}

void GeodesicSearch::start(int source, double limit)
{
  for (const int place : this->ReachedPlaces)
  {
    this->Distances[place] = Infinite;
  }
  for (const int h : this->ViewedHalfedges)
  {
    this->Views[h].Distance = Infinite;
  }
  for (WindowBucket& bucket : this->Buckets)
  {
    bucket.clear();
  }
  this->ReachedPlaces.clear();
  this->ViewedHalfedges.clear();
  this->Trails.clear();
  this->Current = 0;
  this->Limit = limit;
  this->lower(this->Faces.PlaceOf[source], 0.0, { this->Faces.PlaceOf[source] });
}

bool GeodesicSearch::advance(const Checkpoint& checkpoint)
{
  if (this->Current >= this->Buckets.size())
  {
    return false;
  }
  // The references do not outlive a call that may add buckets.
  const auto bucket = [this]() -> WindowBucket& { return this->Buckets[this->Current]; };
  int windows = 0;
  for (int step = 0; !bucket().isEmpty(); step = (step + 1) % StepsPerCheckpoint)
  {
    if (step == 0 && checkpoint)
    {
      checkpoint();
    }
    if (bucket().isPlaceNext())
    {
      const PlaceEvent event = bucket().takePlace();
      if (event.Distance == this->Distances[event.Place])
      {
        this->spreadFrom(event.Place);
      }
      continue;
    }
    const Window window = bucket().takeWindow();
    if (!this->isBeaten(window))
    {
      this->enterFace(window);
    }
    if (++windows == this->Faces.halfedgeCount() / HalfedgesPerUnsortedWindow)
    {
      bucket().sort();
    }
  }
  ++this->Current;
  return true;
}

std::size_t GeodesicSearch::bucketOf(double distance) const
{
  const double index = this->Width > 0.0 ? distance / this->Width : 0.0;
  return std::max(static_cast<std::size_t>(index), this->Current);
}

// Notes a path of the given length to a place.
void GeodesicSearch::lower(int place, double distance, const Arrival& arrival)
{
  double& known = this->Distances[place];
  if (!(distance < known) || distance > this->Limit)
  {
    return;
  }
  if (known == Infinite)
  {
    this->ReachedPlaces.push_back(place);
  }
  known = distance;
  this->Arrivals[place] = arrival;
  const std::size_t index = this->bucketOf(distance);
  if (index >= this->Buckets.size())
  {
    this->Buckets.resize(index + 1);
  }
  this->Buckets[index].add(PlaceEvent{ place, distance });
}

// Paths from a place: along its edges to the neighbours and, if paths bend here, over its faces.
void GeodesicSearch::spreadFrom(int place)
{
  const double distance = this->Distances[place];
  const bool bends = this->Faces.Bends[place] || distance == 0.0;
  for (int c = this->Faces.CornerStarts[place]; c < this->Faces.CornerStarts[place + 1]; ++c)
  {
    const int h = this->Faces.Corners[c];
    const int across = nextHalfedge(h);
    const int before = previousHalfedge(h);
    this->lower(this->Faces.Origin[across], distance + this->Faces.Sides[h].Length, { place });
    this->lower(this->Faces.Origin[before], distance + this->Faces.Sides[before].Length, { place });
    const int opposite = this->Faces.Opposite[across];
    if (bends && opposite >= 0)
    {
      const PlanarSide& side = this->Faces.Sides[across];
      this->push(
        { opposite, 0.0, side.Length, side.Length - side.ApexX, -side.ApexY, distance, place, -1 });
    }
  }
}

// The straight lines of a window cross the face and leave it through one or both of the other sides.
void GeodesicSearch::enterFace(const Window& window)
{
  const int h = window.Halfedge;
  const PlanarSide& side = this->Faces.Sides[h];
  const double height = side.ApexY - window.Y;
  // The straight line from the point to the apex crosses the half-edge at this coordinate.
  const double crossing = window.X - (side.ApexX - window.X) * window.Y / height;
  // The path to the apex bends at an end of the window if the apex is out of its sight.
  const double nearest = std::clamp(crossing, window.Begin, window.End);
  const double distance = window.distanceAt(nearest) + planarNorm(side.ApexX - nearest, side.ApexY);
  this->lower(this->Faces.Origin[previousHalfedge(h)],
    distance,
    { window.Origin, window.Trail, nearest, window.X, window.Y });
  if (crossing <= window.Begin)
  {
    this->pushRight(window, window.Begin, window.End);
  }
  else if (crossing >= window.End)
  {
    this->pushLeft(window, window.Begin, window.End);
  }
  else
  {
    this->splitAtApex(window, crossing, distance);
  }
}

// Several windows of a half-edge may see the apex. The window with the shortest path to the apex goes on
// at both sides of it, the others at one side: on the far side of the shortest path, their paths would
// cross that path ("one angle, one split", Chen and Han).
void GeodesicSearch::splitAtApex(const Window& window, double crossing, double distance)
{
  ApexView& best = this->Views[window.Halfedge];
  if (distance < best.Distance)
  {
    if (best.Distance == Infinite)
    {
      this->ViewedHalfedges.push_back(window.Halfedge);
    }
    best = { distance, crossing };
    this->pushLeft(window, window.Begin, crossing);
    this->pushRight(window, crossing, window.End);
    return;
  }
  // Windows that meet in the line through the vertex between them and the apex see the apex in one
  // place, and rounding decides which is first. Each goes on at its own side.
  const double aside = crossing - best.Crossing;
  const bool isSame = std::abs(aside) <= NarrowestWindow * this->Faces.Sides[window.Halfedge].Length;
  if (isSame ? crossing - window.Begin > window.End - crossing : aside < 0.0)
  {
    this->pushLeft(window, window.Begin, crossing);
  }
  else
  {
    this->pushRight(window, crossing, window.End);
  }
}

// The part [begin, end] of a window leaves the face through the side from the half-edge's begin to the
// apex. The next face is turned about the vertex that both have, by a direction of length 1, so that
// the point stays as far from the vertex: in needles the coordinates of an apex are rounded, and points
// came nearer every time that a window went around one.
void GeodesicSearch::pushLeft(const Window& window, double begin, double end)
{
  const int left = previousHalfedge(window.Halfedge);
  const int opposite = this->Faces.Opposite[left];
  const double length = this->Faces.Sides[left].Length;
  if (opposite < 0 || !(length > 0.0))
  {
    return;
  }
  const PlanarSide& side = this->Faces.Sides[window.Halfedge];
  const double apex = planarNorm(side.ApexX, side.ApexY);
  const double x = side.ApexX / apex;
  const double y = side.ApexY / apex;
  // How far along the side the straight line leaves that crosses the half-edge at @p position.
  const auto leavesAt = [&](double position)
  {
    const double scale = (position - window.X) * y + window.Y * x;
    return scale < 0.0 ? std::clamp(position * window.Y / scale, 0.0, length) : length;
  };
  const Window next{ opposite,
    leavesAt(begin),
    leavesAt(end),
    window.X * x + window.Y * y,
    window.Y * x - window.X * y,
    window.Before,
    window.Origin,
    window.Trail,
    window.Passed,
    window.Earlier };
  // A path from the far end of the half-edge that meets all lines of the window.
  const int far = this->Faces.Origin[nextHalfedge(window.Halfedge)];
  const double aside = planarNorm(next.Begin * x - side.Length, next.Begin * y);
  if (this->Distances[far] + aside > next.distanceAt(next.Begin))
  {
    this->push(next);
  }
}

// The same through the side from the apex to the half-edge's end.
void GeodesicSearch::pushRight(const Window& window, double begin, double end)
{
  const int right = nextHalfedge(window.Halfedge);
  const int opposite = this->Faces.Opposite[right];
  const double length = this->Faces.Sides[right].Length;
  if (opposite < 0 || !(length > 0.0))
  {
    return;
  }
  const PlanarSide& side = this->Faces.Sides[window.Halfedge];
  // The direction from the apex to the half-edge's end.
  const double apex = planarNorm(side.Length - side.ApexX, side.ApexY);
  const double x = (side.Length - side.ApexX) / apex;
  const double y = -side.ApexY / apex;
  const auto leavesAt = [&](double position)
  {
    const double scale = (position - window.X) * -y - window.Y * x;
    const double toEnd = scale > 0.0 ? (position - side.Length) * window.Y / scale : length;
    return length - std::clamp(toEnd, 0.0, length);
  };
  const double fromEnd = window.X - side.Length;
  const Window next{ opposite,
    leavesAt(begin),
    leavesAt(end),
    length + fromEnd * x + window.Y * y,
    window.Y * x - fromEnd * y,
    window.Before,
    window.Origin,
    window.Trail,
    window.Passed,
    window.Earlier };
  const int far = this->Faces.Origin[window.Halfedge];
  const double aside = planarNorm(side.ApexX + next.End * x, side.ApexY + next.End * y);
  if (this->Distances[far] + aside > next.distanceAt(next.End))
  {
    this->push(next);
  }
}

// Whether a path through an end of its edge is as short for all that the window reaches.
bool GeodesicSearch::isBeaten(const Window& window) const
{
  const double length = this->Faces.Sides[window.Halfedge].Length;
  const double begin = this->Distances[this->Faces.Origin[window.Halfedge]];
  const double end = this->Distances[this->Faces.Origin[nextHalfedge(window.Halfedge)]];
  return begin + window.End <= window.distanceAt(window.End) ||
         end + length - window.Begin <= window.distanceAt(window.Begin);
}

void GeodesicSearch::push(Window window)
{
  const double length = this->Faces.Sides[window.Halfedge].Length;
  if (!(window.End - window.Begin > NarrowestWindow * length) || !(window.Y < 0.0) ||
      this->isBeaten(window) || window.Halfedge == window.Earlier)
  {
    return;
  }
  // No shortest path crosses a half-edge twice. A window that goes around a needle again and again is
  // found out when it comes to the half-edge that it has noted (Brent 1980, "An improved Monte Carlo
  // factorization algorithm", section 2).
  ++window.Passed;
  if ((window.Passed & (window.Passed - 1)) == 0)
  {
    window.Earlier = window.Halfedge;
  }
  window.Nearest = window.nearest();
  if (!(window.Nearest <= this->Limit))
  {
    return;
  }
  const std::size_t index = this->bucketOf(window.Nearest);
  if (index >= this->Buckets.size())
  {
    this->Buckets.resize(index + 1);
  }
  if (this->KeptPaths == Paths::Kept)
  {
    this->Trails.push_back({ window.Halfedge, window.Trail });
    window.Trail = static_cast<int>(this->Trails.size()) - 1;
  }
  this->Buckets[index].add(window);
}

} // namespace flattening
