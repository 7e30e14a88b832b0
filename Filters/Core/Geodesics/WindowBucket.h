// SPDX-License-Identifier: GPL-3.0-or-later
/// The windows and places that a search for geodesics has before it.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace flattening
{

/// The length of a vector, without the care of std::hypot for extreme numbers, which takes most of the
/// time of a search.
inline double planarNorm(double x, double y)
{
  return std::sqrt(x * x + y * y);
}

/// The interval of a half-edge that straight lines from one point reach before they enter its face. The
/// point lies below the half-edge in the plane of the face (see PlanarSide). Lengths are in input units.
struct GeodesicWindow
{
  int Halfedge;
  double Begin; ///< along the half-edge
  double End;
  double X; ///< of the point
  double Y;
  double Before;        ///< distance of the point from the source
  int Origin;           ///< the place that the point is an image of
  int Trail;            ///< of the half-edges before this one; once it is queued, with this one
  int Passed = 0;       ///< how many half-edges its lines cross
  int Earlier = -1;     ///< one of them: the last whose number was a power of 2
  double Nearest = 0.0; ///< the least of its distances, once it is queued

  bool operator<(const GeodesicWindow& other) const { return other.Nearest < this->Nearest; }

  double distanceAt(double position) const;
  double nearest() const;
};

/// A place to which a path of that length is known.
struct PlaceEvent
{
  int Place;
  double Distance; ///< input units

  bool operator<(const PlaceEvent& other) const { return other.Distance < this->Distance; }
};

/// Windows and places that are processed together: their distances differ by less than the width of the
/// bucket. Of the places the nearest comes first, and then of the windows the oldest, which is quick.
/// But where a whole region of small faces lies in one bucket, it is spread over again and again, for
/// ever shorter paths. There the nearest window or place comes first, once the bucket is sorted.
class WindowBucket
{
public:
  bool isEmpty() const { return this->Places.empty() && this->NextWindow == this->Windows.size(); }
  bool isPlaceNext() const;
  PlaceEvent takePlace();
  GeodesicWindow takeWindow();
  void add(const PlaceEvent& place);
  void add(const GeodesicWindow& window);
  void sort();
  void clear();

private:
  std::vector<PlaceEvent> Places;      // a heap
  std::vector<GeodesicWindow> Windows; // a heap if the bucket is sorted
  std::size_t NextWindow = 0;          // 0 if it is sorted
  bool IsSorted = false;
};

} // namespace flattening
