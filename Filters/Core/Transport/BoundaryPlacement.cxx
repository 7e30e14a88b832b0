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

// How near a vertex may come to a corner, in mean gaps between neighbours. A guard: with 0 the vertices
// of cells beyond a corner would fall onto it.
constexpr double LeastGap = 0.1;
// The same for two neighbours. Where a site's cell has no part of the boundary, as those of thousands of
// vertices in long narrow parts of a surface, their places would be equal by rounding, and no energy
// of their gaps is finite. So little that areas still decide: with 1e-3, a region of weight 1000 had 4 %
// too little area.
constexpr double LeastNeighbourGap = 1e-6;

// Neighbouring values that share their mean.
struct Pool
{
  double Sum;
  int Count;
  double mean() const { return this->Sum / this->Count; }
};

double preferredParameter(const PowerDiagram& diagram, int site)
{
  const PowerDiagram::BoundaryPart part = diagram.boundaryPart(site);
  return part.Length > 0.0 ? part.Middle
                           : diagram.domain().parameterOf(diagram.centroids().row(site).transpose());
}

// The parameters of vertices that may slide all around the boundary.
std::vector<double> slidingParameters(const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex)
{
  const double turn = diagram.domain().perimeter();
  const int n = static_cast<int>(loop.size());
  std::vector<double> parameters(n);
  for (int k = 0; k < n; ++k)
  {
    parameters[k] = preferredParameter(diagram, siteOfVertex[loop[k]]);
  }
  // Cut the boundary in its widest gap, so that the order of the vertices does not break near the cut.
  int cut = 0;
  double widest = -1.0;
  for (int k = 0; k < n; ++k)
  {
    const double gap = std::remainder(parameters[k] - parameters[(k + n - 1) % n], turn);
    if (gap > widest)
    {
      widest = gap;
      cut = k;
    }
  }
  std::vector<double> unrolled(n);
  for (int k = 0; k < n; ++k)
  {
    const double parameter = parameters[(cut + k) % n];
    unrolled[k] =
      k == 0 ? parameter : unrolled[k - 1] + std::remainder(parameter - unrolled[k - 1], turn);
  }
  const double leastGap = LeastNeighbourGap * turn / n;
  std::vector<double> fit = strictlyIncreasingFit(unrolled, leastGap);
  // Least gaps may fill the widest one, too.
  const double span = fit.back() - fit.front();
  const double shrink = std::min(1.0, (turn - leastGap) / span);
  std::transform(fit.begin(),
    fit.end(),
    fit.begin(),
    [shrink, first = fit.front()](double value) { return first + shrink * (value - first); });
  for (int k = 0; k < n; ++k)
  {
    // Vertices before the cut came one turn later: let the parameters increase from the first vertex.
    parameters[(cut + k) % n] = k < n - cut ? fit[k] : fit[k] - turn;
  }
  return parameters;
}

// The parameters of vertices between corners where other vertices stay.
std::vector<double> parametersBetweenCorners(const PowerDiagram& diagram,
  const BoundaryLoop& boundary,
  const std::vector<int>& siteOfVertex)
{
  const std::vector<int>& loop = boundary.Vertices;
  const std::vector<int>& corners = boundary.Corners;
  const std::vector<double>& cornerParameters = boundary.CornerParameters;
  const double turn = diagram.domain().perimeter();
  const int n = static_cast<int>(loop.size());
  std::vector<double> parameters(n);
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    const bool isLast = c + 1 == corners.size();
    const int first = corners[c];
    const int count = (isLast ? corners[0] + n : corners[c + 1]) - first; // sides of the loop
    const double start = cornerParameters[c];
    const double end = isLast ? cornerParameters[0] + turn : cornerParameters[c + 1];
    const double margin = LeastGap * (end - start) / count;
    const double leastGap = LeastNeighbourGap * (end - start) / count;
    std::vector<double> between{ start };
    for (int k = 1; k < count; ++k)
    {
      const double parameter = preferredParameter(diagram, siteOfVertex[loop[(first + k) % n]]);
      const double middle = 0.5 * (start + end);
      const double unrolled = middle + std::remainder(parameter - middle, turn);
      between.push_back(std::clamp(unrolled,
        start + margin + (k - 1) * leastGap,
        end - margin - (count - 1 - k) * leastGap)); // room for the others
    }
    between.push_back(end);
    const std::vector<double> fit = strictlyIncreasingFit(between, leastGap);
    for (int k = 0; k < count; ++k)
    {
      parameters[(first + k) % n] = fit[k];
    }
  }
  return parameters;
}

} // namespace

std::vector<double> strictlyIncreasingFit(const std::vector<double>& values, double leastGap)
{
  // Values whose gaps are at least the least one do not decrease when each loses its share of the gaps.
  std::vector<Pool> pools;
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    pools.push_back({ values[k] - static_cast<double>(k) * leastGap, 1 });
    while (pools.size() > 1 && pools[pools.size() - 2].mean() >= pools.back().mean())
    {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().Sum += last.Sum;
      pools.back().Count += last.Count;
    }
  }
  std::vector<double> fit;
  for (std::size_t p = 0; p < pools.size(); ++p)
  {
    const double mean = pools[p].mean();
    // A third of the smaller of both gaps; a single pool has no gaps, and any width does.
    double width = 1.0;
    width = p > 0 ? std::min(width, mean - pools[p - 1].mean()) : width;
    width = p + 1 < pools.size() ? std::min(width, pools[p + 1].mean() - mean) : width;
    for (int k = 0; k < pools[p].Count; ++k)
    {
      const double spread =
        pools[p].Count == 1 ? 0.0 : width / 3.0 * (2.0 * k / (pools[p].Count - 1.0) - 1.0);
      fit.push_back(mean + spread + static_cast<double>(fit.size()) * leastGap);
    }
  }
  return fit;
}

std::vector<double> boundaryParameters(const PowerDiagram& diagram,
  const BoundaryLoop& boundary,
  const std::vector<int>& siteOfVertex)
{
  return boundary.Corners.empty() ? slidingParameters(diagram, boundary.Vertices, siteOfVertex)
                                  : parametersBetweenCorners(diagram, boundary, siteOfVertex);
}

std::vector<int> cornerMembers(const PowerDiagram& diagram,
  const std::vector<int>& loop,
  const std::vector<int>& siteOfVertex,
  const std::vector<double>& cornerParameters)
{
  const int n = static_cast<int>(loop.size());
  const int count = static_cast<int>(cornerParameters.size());
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
    middles[k] = preferredParameter(diagram, siteOfVertex[loop[k]]);
    halfLengths[k] = 0.5 * diagram.boundaryPart(siteOfVertex[loop[k]]).Length;
  }
  // The distance of a point from a vertex's part of the boundary, and then from the part's middle.
  const auto apart = [&](int member, double fromMiddle)
  { return std::pair(std::max(0.0, fromMiddle - halfLengths[member]), fromMiddle); };
  const auto apartAtFirst = [&](int k)
  { return apart(k, std::abs(std::remainder(middles[k] - cornerParameters[0], turn))); };
  int first = 0;
  for (int k = 1; k < n; ++k)
  {
    first = apartAtFirst(k) < apartAtFirst(first) ? k : first;
  }
  // The same for the other corners, along the boundary from the first corner once around.
  const auto apartAt = [&](int k, double parameter)
  {
    const double fromFirst = middles[k % n] - cornerParameters[0];
    const double unrolled = fromFirst - turn * std::floor(fromFirst / turn);
    return apart(k % n, std::abs(unrolled - (parameter - cornerParameters[0])));
  };
  std::vector<int> members{ first };
  for (int c = 1; c < count; ++c)
  {
    // After the vertex of the previous corner, leaving one vertex for each following corner.
    int best = members.back() + 1;
    for (int k = best; k < first + n - (count - 1 - c); ++k)
    {
      best = apartAt(k, cornerParameters[c]) < apartAt(best, cornerParameters[c]) ? k : best;
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
