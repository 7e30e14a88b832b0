// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatPlaces.h"

#include <algorithm>
#include <cmath>

namespace fuzz
{
namespace
{

// The rounding of a product in double precision, as a share of its factors.
constexpr long double DoubleRounding = 1e-15L;

using Vector = std::array<long double, 2>;

Vector between(const Point& from, const Point& to)
{
  return { static_cast<long double>(to[0]) - from[0], static_cast<long double>(to[1]) - from[1] };
}

long double cross(const Vector& u, const Vector& v)
{
  return u[0] * v[1] - u[1] * v[0];
}

// The nearest place on the sides.
void placeOnSides(const std::array<const Point*, 3>& corners, const Point& point, FlatPlace& place)
{
  place.Distance = HUGE_VALL;
  for (int k = 0; k < 3; ++k)
  {
    const Vector side = between(*corners[k], *corners[(k + 1) % 3]);
    const Vector to = between(*corners[k], point);
    const long double length = std::hypot(side[0], side[1]);
    const long double along =
      length > 0.0L ? (to[0] * (side[0] / length) + to[1] * (side[1] / length)) / length : 0.0L;
    const long double share = std::clamp(along, 0.0L, 1.0L);
    const long double distance = std::hypot(to[0] - share * side[0], to[1] - share * side[1]);
    if (distance < place.Distance)
    {
      place.Distance = distance;
      place.Weights = { 0.0L, 0.0L, 0.0L };
      place.Weights[k] = 1.0L - share;
      place.Weights[(k + 1) % 3] += share;
    }
  }
}

} // namespace

FlatPlace placeOn(const Triangles& map, std::size_t face, const Point& point)
{
  FlatPlace place{ face, 0.0L, {}, {}, 1.0L, false };
  std::array<const Point*, 3> corners;
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = &map.Points[map.Faces[face][k]];
  }
  const long double area = cross(between(*corners[0], *corners[1]), between(*corners[0], *corners[2]));
  place.HasArea = area != 0.0L;
  bool isInside = place.HasArea;
  long double longest = 0.0L;
  for (int k = 0; k < 3; ++k)
  {
    const Point& from = *corners[(k + 1) % 3];
    const Vector side = between(from, *corners[(k + 2) % 3]);
    longest = std::max(longest, std::hypot(side[0], side[1]));
    if (place.HasArea)
    {
      place.Gradients[k] = { -side[1] / area, side[0] / area };
      place.Weights[k] = cross(side, between(from, point)) / area;
      isInside = isInside && place.Weights[k] >= 0.0L;
    }
  }
  if (place.HasArea)
  {
    place.WeightError = std::min(1.0L, DoubleRounding * (longest / std::abs(area)) * longest);
  }
  if (!isInside)
  {
    placeOnSides(corners, point, place);
  }
  return place;
}

std::vector<FlatPlace> nearestPlaces(const Triangles& map, const Point& point, long double slack)
{
  std::vector<FlatPlace> places;
  long double nearest = HUGE_VALL;
  for (std::size_t f = 0; f < map.Faces.size(); ++f)
  {
    const FlatPlace place = placeOn(map, f, point);
    if (place.HasArea && place.Distance <= nearest + slack)
    {
      nearest = std::min(nearest, place.Distance);
      places.push_back(place);
    }
  }
  places.erase(std::remove_if(places.begin(),
                 places.end(),
                 [&](const FlatPlace& place) { return place.Distance > nearest + slack; }),
    places.end());
  std::stable_sort(places.begin(),
    places.end(),
    [](const FlatPlace& a, const FlatPlace& b) { return a.Distance < b.Distance; });
  return places;
}

Interval valuesAt(const FlatPlace& place,
  const std::array<long double, 3>& corners,
  long double rounding)
{
  const auto [least, greatest] = std::minmax_element(corners.begin(), corners.end());
  if (!place.HasArea)
  {
    return { *least, *greatest };
  }
  // The differences from one corner, so that a surface far off loses no digits.
  long double value = corners[0];
  Vector gradient{ 0.0L, 0.0L };
  for (int k = 1; k < 3; ++k)
  {
    const long double change = corners[k] - corners[0];
    value += place.Weights[k] * change;
    gradient[0] += place.Gradients[k][0] * change;
    gradient[1] += place.Gradients[k][1] * change;
  }
  const long double error =
    rounding * std::hypot(gradient[0], gradient[1]) + place.WeightError * (*greatest - *least);
  return { std::clamp(value - error, *least, *greatest), std::clamp(value + error, *least, *greatest) };
}

long double weightRounding(const FlatPlace& place, int corner, long double rounding)
{
  const Vector& gradient = place.Gradients[corner];
  return place.HasArea
           ? std::min(1.0L, rounding * std::hypot(gradient[0], gradient[1]) + place.WeightError)
           : 1.0L;
}

Square squareAround(const Triangles& map)
{
  long double low[2] = { HUGE_VALL, HUGE_VALL };
  long double high[2] = { -HUGE_VALL, -HUGE_VALL };
  for (const Point& point : map.Points)
  {
    for (int k = 0; k < 2; ++k)
    {
      low[k] = std::min(low[k], static_cast<long double>(point[k]));
      high[k] = std::max(high[k], static_cast<long double>(point[k]));
    }
  }
  Square square;
  square.Side = std::max(high[0] - low[0], high[1] - low[1]);
  square.Greatest =
    std::max({ std::abs(low[0]), std::abs(low[1]), std::abs(high[0]), std::abs(high[1]) });
  for (int k = 0; k < 2; ++k)
  {
    square.Low[k] = 0.5L * (low[k] + high[k]) - 0.5L * square.Side;
  }
  return square;
}

} // namespace fuzz
