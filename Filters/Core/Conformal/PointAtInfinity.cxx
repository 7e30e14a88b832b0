// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/PointAtInfinity.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{

std::vector<char> boundaryVertices(const IntrinsicTriangulation& t)
{
  std::vector<char> onBoundary(t.vertexCount(), 0);
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    if (t.twin(h) < 0)
    {
      onBoundary[t.origin(h)] = onBoundary[t.tip(h)] = 1;
    }
  }
  return onBoundary;
}

// A heuristic measure of how well the vertex can go to infinity; negative if it cannot. The Ricci flow
// cannot flip the edges around infinity, so stars are preferred whose edges need no flip.
double starQuality(const IntrinsicTriangulation& t, const std::vector<char>& onBoundary, int vertex)
{
  const std::vector<int> around = t.outgoing(vertex);
  if (around.size() < 2 || static_cast<int>(around.size()) == t.faceCount())
  {
    return -1.0;
  }
  std::vector<int> link;
  double smallestAngle = EIGEN_PI;
  double angleSum = 0.0;
  double slack = EIGEN_PI; // least reserve of the Delaunay condition across the link, radians
  for (const int h : around)
  {
    link.push_back(t.tip(h));
    const auto anglesAt = [&t](int k)
    { return triangleAngles(t.logLength(k), t.logLength(t.next(k)), t.logLength(t.previous(k))); };
    const TriangleAngles angles = anglesAt(t.next(h)); // the first is the angle at the vertex
    smallestAngle = std::min({ smallestAngle, angles.Angle[0], angles.Angle[1], angles.Angle[2] });
    angleSum += angles.Angle[0];
    if (t.twin(t.next(h)) >= 0)
    {
      slack = std::min<double>(slack, EIGEN_PI - angles.Angle[0] - anglesAt(t.twin(t.next(h))).Angle[0]);
    }
  }
  link.push_back(t.origin(t.previous(around.back())));
  for (std::size_t k = 1; k + 1 < link.size(); ++k)
  {
    if (onBoundary[link[k]])
    {
      return -1.0;
    }
  }
  link.push_back(vertex);
  std::sort(link.begin(), link.end());
  if (std::adjacent_find(link.begin(), link.end()) != link.end())
  {
    return -1.0;
  }
  return smallestAngle * (0.2 + std::clamp(slack, 0.0, 1.0)) * std::exp(-std::abs(angleSum - EIGEN_PI));
}

} // namespace

std::vector<int> verticesForInfinity(const IntrinsicTriangulation& triangulation)
{
  const std::vector<char> onBoundary = boundaryVertices(triangulation);
  std::vector<std::pair<double, int>> rated;
  for (int v = 0; v < triangulation.vertexCount(); ++v)
  {
    const double quality = onBoundary[v] ? starQuality(triangulation, onBoundary, v) : -1.0;
    if (quality > 0.0)
    {
      rated.emplace_back(-quality, v);
    }
  }
  std::sort(rated.begin(), rated.end());
  std::vector<int> vertices;
  for (const auto& [quality, vertex] : rated)
  {
    vertices.push_back(vertex);
  }
  return vertices;
}

} // namespace flattening
