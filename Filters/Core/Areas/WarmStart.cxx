// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/WarmStart.h"

#include "Mesh/FaceOrientation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{

// Of a domain of area pi: what scaling to the output and back costs a point on the boundary.
constexpr double BoundaryTolerance = 1e-6;

// The same places growing over less than a turn from the first, if the loop is in order.
std::vector<double> fromTheFirst(std::vector<double> places, double turn)
{
  for (double& place : places)
  {
    const double along = place - places.front();
    place = places.front() + along - turn * std::floor(along / turn);
  }
  return places;
}

} // namespace

bool isRefinedMap(const Points2& positions,
  const FaceMatrix& faces,
  const ConvexDomain& domain,
  const std::vector<int>& loop,
  const std::vector<int>& corners,
  const std::vector<double>& cornerPlaces)
{
  if (!positions.allFinite())
  {
    return false;
  }
  const auto isAt = [&](int v, double place)
  { return (domain.at(place).transpose() - positions.row(v)).norm() <= BoundaryTolerance; };
  std::vector<double> places;
  for (const int v : loop)
  {
    places.push_back(domain.placeOf(positions.row(v).transpose()));
  }
  places = fromTheFirst(std::move(places), domain.perimeter());
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    if (!isAt(loop[k], places[k]) || (k > 0 && !(places[k] > places[k - 1])))
    {
      return false;
    }
  }
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    if (!isAt(loop[corners[c]], cornerPlaces[c]))
    {
      return false;
    }
  }
  return countFlippedFaces(positions, faces) == 0;
}

Points2 carriedMap(const Points2& positions,
  const TransportSites& sites,
  const TransportedSites& before,
  const TransportedSites& after,
  const std::vector<int>& loop,
  const ConvexDomain& domain)
{
  const TransportSites moved{ before.Images.Positions, sites.SiteOfVertex };
  Points2 result = interpolateTransport(moved, after.Images, positions, domain);

  const double turn = domain.perimeter();
  std::vector<double> from = fromTheFirst(before.Places, turn);
  std::vector<double> to = fromTheFirst(after.Places, turn);
  from.push_back(from.front() + turn);
  to.push_back(to.front() + turn);
  for (const int v : loop)
  {
    const double along = domain.placeOf(positions.row(v).transpose()) - from.front();
    const double place = from.front() + along - turn * std::floor(along / turn);
    const auto above = std::upper_bound(from.begin(), from.end() - 1, place);
    const std::size_t k = above - from.begin();
    const double share = std::clamp((place - from[k - 1]) / (from[k] - from[k - 1]), 0.0, 1.0);
    result.row(v) = domain.at((1.0 - share) * to[k - 1] + share * to[k]).transpose();
  }
  return result;
}

} // namespace flattening
