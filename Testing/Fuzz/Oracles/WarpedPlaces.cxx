// SPDX-License-Identifier: GPL-3.0-or-later
#include "WarpedPlaces.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

namespace fuzz
{
namespace
{

// The rounding of a position that was interpolated, as a share of the greatest coordinate.
constexpr long double InterpolationRounding = 1e-12L;

Interval rangeOf(const Triangles& mesh, int axis)
{
  Interval range{ HUGE_VALL, -HUGE_VALL };
  for (const Point& point : mesh.Points)
  {
    range.Low = std::min<long double>(range.Low, point[axis]);
    range.High = std::max<long double>(range.High, point[axis]);
  }
  return range;
}

Position interpolated(const Triangles& mesh,
  const Triangle& face,
  const std::array<long double, 3>& weights)
{
  Position sum = { 0.0L, 0.0L };
  for (int k = 0; k < 3; ++k)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      sum[axis] += weights[k] * mesh.Points[face[k]][axis];
    }
  }
  return sum;
}

} // namespace

PlanarMesh planarMeshOf(Triangles mesh)
{
  const Interval x = rangeOf(mesh, 0);
  const Interval y = rangeOf(mesh, 1);
  const Interval z = rangeOf(mesh, 2);
  for (Point& point : mesh.Points)
  {
    point[2] = 0.0;
  }
  const long double coordinate = squareAround(mesh).Greatest;
  return { std::move(mesh), coordinate, std::hypot(x.High - x.Low, y.High - y.Low), z };
}

WarpedPlaces warpedPlaces(const PlanarMesh& from, const PlanarMesh& to, const Point& point)
{
  WarpedPlaces warped{ HUGE_VALL, {} };
  std::vector<FlatPlace> places;
  for (std::size_t f = 0; f < from.Mesh.Faces.size(); ++f)
  {
    places.push_back(placeOn(from.Mesh, f, point));
    warped.Distance = std::min(warped.Distance, places.back().Distance);
  }
  const long double rounding =
    PlaceRounding * std::max<long double>({ from.Coordinate, std::abs(point[0]), std::abs(point[1]) });
  const long double thickness = from.Heights.High - from.Heights.Low;
  for (const FlatPlace& place : places)
  {
    const Triangle& face = from.Mesh.Faces[place.Face];
    const long double height = 2.0L * areaOf(from.Mesh, face) /
                               std::sqrt(std::max(greatestSquaredSide(from.Mesh, face), LDBL_MIN));
    // The nearest point of a face that rises a little is not right below.
    const long double offset = rounding + thickness * (height > thickness ? thickness / height : 1.0L);
    if (place.Distance <= warped.Distance + offset)
    {
      const long double share = height > offset ? offset / height : 1.0L;
      warped.Places.push_back({ interpolated(to.Mesh, face, place.Weights),
        InterpolationRounding * to.Coordinate +
          2.0L * share * std::sqrt(greatestSquaredSide(to.Mesh, face)),
        face });
    }
  }
  return warped;
}

bool fits(const WarpedPlaces& warped, const PlanarMesh& to, const Point& point)
{
  const Point inPlane = { point[0], point[1], 0.0 };
  return std::any_of(warped.Places.begin(),
    warped.Places.end(),
    [&](const WarpedPlace& one)
    {
      return std::hypot(one.Place[0] - point[0], one.Place[1] - point[1]) <= one.Rounding &&
             distanceTo(to.Mesh, one.Face, inPlane) <= InterpolationRounding * to.Coordinate;
    });
}

} // namespace fuzz
