// SPDX-License-Identifier: GPL-3.0-or-later
/// The places of a flat map nearest to a point of its plane, found among all faces, and the values of
/// point arrays there.
#pragma once

#include "Triangles.h"

#include <array>
#include <cstddef>
#include <vector>

namespace fuzz
{

/// The place of a face that is nearest to a point.
struct FlatPlace
{
  std::size_t Face;
  long double Distance; ///< 0 in the face
  std::array<long double, 3> Weights;
  std::array<std::array<long double, 2>, 3> Gradients; ///< of the weights, in the plane
  long double WeightError; ///< rounding of weights that were computed in double precision
  bool HasArea;            ///< otherwise the gradients are 0
};

/// The numbers between two, both included.
struct Interval
{
  long double Low;
  long double High;
};

FlatPlace placeOn(const Triangles& map, std::size_t face, const Point& point);

/// The place of each face that is at most @p slack farther away than the nearest, among the faces that
/// have an area.
std::vector<FlatPlace> nearestPlaces(const Triangles& map, const Point& point, long double slack);

/// The values that a point array with the given values at the corners can have at a place, if that is
/// known up to @p rounding (units of the map).
Interval valuesAt(const FlatPlace& place,
  const std::array<long double, 3>& corners,
  long double rounding);

/// How much the weight of a corner changes if the place moves by @p rounding; at most 1.
long double weightRounding(const FlatPlace& place, int corner, long double rounding);

/// The smallest square around a flat map with the same centre.
struct Square
{
  long double Low[2];
  long double Side;
  long double Greatest; ///< the greatest absolute value of a coordinate
};

Square squareAround(const Triangles& map);

} // namespace fuzz
