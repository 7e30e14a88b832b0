// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshLengths.h"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace fuzz
{

long double distanceBetween(const Point& a, const Point& b)
{
  return std::hypot(static_cast<long double>(a[0]) - b[0],
    static_cast<long double>(a[1]) - b[1],
    static_cast<long double>(a[2]) - b[2]);
}

long double meanSide(const Triangles& mesh)
{
  long double sum = 0.0L;
  for (const Triangle& face : mesh.Faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      sum += distanceBetween(mesh.Points[face[k]], mesh.Points[face[(k + 1) % 3]]);
    }
  }
  return sum / (3.0L * static_cast<long double>(mesh.Faces.size()));
}

std::vector<long double> distancesFrom(const Triangles& mesh, const std::vector<vtkIdType>& sources)
{
  std::vector<std::vector<vtkIdType>> neighbours(mesh.Points.size());
  for (const Triangle& face : mesh.Faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      neighbours[face[k]].push_back(face[(k + 1) % 3]);
      neighbours[face[(k + 1) % 3]].push_back(face[k]);
    }
  }
  std::vector<long double> distance(mesh.Points.size(), HUGE_VALL);
  using Reached = std::pair<long double, vtkIdType>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  for (const vtkIdType source : sources)
  {
    distance[source] = 0.0L;
    queue.push({ 0.0L, source });
  }
  while (!queue.empty())
  {
    const auto [length, p] = queue.top();
    queue.pop();
    for (const vtkIdType q : neighbours[p])
    {
      const long double longer = length + distanceBetween(mesh.Points[p], mesh.Points[q]);
      if (length == distance[p] && longer < distance[q])
      {
        distance[q] = longer;
        queue.push({ longer, q });
      }
    }
  }
  return distance;
}

} // namespace fuzz
