// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/BoundaryPlacement.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

struct Pool
{
  double Sum;
  int Count;
  double mean() const { return this->Sum / this->Count; }
};

double preferredPlace(const PowerDiagram& diagram, int site)
{
  const PowerDiagram::BoundaryPart part = diagram.boundaryPart(site);
  return part.Length > 0.0 ? part.Middle
                           : diagram.domain().placeOf(diagram.centroids().row(site).transpose());
}

// Of the mean gap between neighbours: how near a vertex may come to a corner.
constexpr double LeastGap = 0.1;

} // namespace

std::vector<double> strictlyIncreasingFit(const std::vector<double>& values)
{
  std::vector<Pool> pools;
  for (const double value : values)
  {
    pools.push_back({ value, 1 });
    while (pools.size() > 1 && pools[pools.size() - 2].mean() >= pools.back().mean())
    {
      pools[pools.size() - 2].Sum += pools.back().Sum;
      pools[pools.size() - 2].Count += pools.back().Count;
      pools.pop_back();
    }
  }
  std::vector<double> fit;
  for (std::size_t p = 0; p < pools.size(); ++p)
  {
    const double mean = pools[p].mean();
    // A third of the smaller gap to either side; with no neighbour at all any width does.
    double width = 1.0;
    width = p > 0 ? std::min(width, mean - pools[p - 1].mean()) : width;
    width = p + 1 < pools.size() ? std::min(width, pools[p + 1].mean() - mean) : width;
    for (int k = 0; k < pools[p].Count; ++k)
    {
      fit.push_back(
        pools[p].Count == 1 ? mean : mean + width / 3.0 * (2.0 * k / (pools[p].Count - 1.0) - 1.0));
    }
  }
  return fit;
}

std::vector<double> boundaryParameters(const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex)
{
  const double turn = diagram.domain().perimeter();
  const int n = static_cast<int>(loop.size());
  std::vector<double> places(n);
  for (int k = 0; k < n; ++k)
  {
    places[k] = preferredPlace(diagram, siteOfVertex[loop[k]]);
  }
  // Unroll the boundary where the widest gap is, so that the order can break nowhere near the cut.
  int cut = 0;
  double widest = -1.0;
  for (int k = 0; k < n; ++k)
  {
    const double gap = std::remainder(places[k] - places[(k + n - 1) % n], turn);
    if (gap > widest)
    {
      widest = gap;
      cut = k;
    }
  }
  std::vector<double> unrolled(n);
  for (int k = 0; k < n; ++k)
  {
    const double place = places[(cut + k) % n];
    unrolled[k] = k == 0 ? place : unrolled[k - 1] + std::remainder(place - unrolled[k - 1], turn);
  }
  const std::vector<double> fit = strictlyIncreasingFit(unrolled);
  for (int k = 0; k < n; ++k)
  {
    places[(cut + k) % n] = fit[k];
  }
  for (int k = n - cut; k < n; ++k)
  {
    // Members before the cut follow one turn later: keep the loop increasing from its first vertex.
    places[(cut + k) % n] -= turn;
  }
  return places;
}

std::vector<double> boundaryParameters(const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex,
  const std::vector<int>& corners,
  const std::vector<double>& cornerPlaces)
{
  const double turn = diagram.domain().perimeter();
  const int n = static_cast<int>(loop.size());
  std::vector<double> places(n);
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    const bool isLast = c + 1 == corners.size();
    const int first = corners[c];
    const int count = (isLast ? corners[0] + n : corners[c + 1]) - first; // sides of the loop
    const double start = cornerPlaces[c];
    const double end = isLast ? cornerPlaces[0] + turn : cornerPlaces[c + 1];
    const double margin = LeastGap * (end - start) / count;
    std::vector<double> between{ start };
    for (int k = 1; k < count; ++k)
    {
      const double place = preferredPlace(diagram, siteOfVertex[loop[(first + k) % n]]);
      const double middle = 0.5 * (start + end);
      const double unrolled = middle + std::remainder(place - middle, turn);
      between.push_back(std::clamp(unrolled, start + margin, end - margin));
    }
    between.push_back(end);
    const std::vector<double> fit = strictlyIncreasingFit(between);
    for (int k = 0; k < count; ++k)
    {
      places[(first + k) % n] = fit[k];
    }
  }
  return places;
}

std::vector<int> cornerMembers(const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex,
  const std::vector<double>& cornerPlaces)
{
  const int n = static_cast<int>(loop.size());
  const int count = static_cast<int>(cornerPlaces.size());
  if (n < count)
  {
    throw InvalidInput("the boundary has " + std::to_string(n) + " points, the domain " +
                       std::to_string(count) +
                       " corners: turn Fix Corners off or give a polygon of fewer corners");
  }
  const double turn = diagram.domain().perimeter();
  std::vector<double> middles(n);
  std::vector<double> halfLengths(n);
  for (int k = 0; k < n; ++k)
  {
    middles[k] = preferredPlace(diagram, siteOfVertex[loop[k]]);
    halfLengths[k] = 0.5 * diagram.boundaryPart(siteOfVertex[loop[k]]).Length;
  }
  // How far from the part, and among parts that have the place, from their middle.
  const auto apart = [&](int member, double fromMiddle)
  { return std::pair(std::max(0.0, fromMiddle - halfLengths[member]), fromMiddle); };
  const auto apartAtFirst = [&](int k)
  { return apart(k, std::abs(std::remainder(middles[k] - cornerPlaces[0], turn))); };
  int first = 0;
  for (int k = 1; k < n; ++k)
  {
    first = apartAtFirst(k) < apartAtFirst(first) ? k : first;
  }
  // From there on once around.
  const auto apartAt = [&](int k, double place)
  {
    const double fromFirst = middles[k % n] - cornerPlaces[0];
    const double unrolled = fromFirst - turn * std::floor(fromFirst / turn);
    return apart(k % n, std::abs(unrolled - (place - cornerPlaces[0])));
  };
  std::vector<int> members{ first };
  for (int c = 1; c < count; ++c)
  {
    // After the member of the corner before, with one left for each corner to come.
    int best = members.back() + 1;
    for (int k = best; k < first + n - (count - 1 - c); ++k)
    {
      best = apartAt(k, cornerPlaces[c]) < apartAt(best, cornerPlaces[c]) ? k : best;
    }
    members.push_back(best);
  }
  for (int& member : members)
  {
    member %= n;
  }
  return members;
}

} // namespace flattening
