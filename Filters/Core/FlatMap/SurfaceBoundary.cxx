// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/SurfaceBoundary.h"

#include "Mesh/MeshTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace flattening
{
namespace
{

// The number of points of the last edge of a seam that are looked for in a triangle. With fewer, more of
// the edge may lie in a triangle without being seen.
constexpr int PointsOfSeamEnd = 8;

// A point is inside a triangle if its barycentric coordinates are greater than this. The value is above
// rounding; with a greater one the seam may run farther into the triangle.
constexpr double InsideTriangle = 1e-6;

} // namespace

SurfaceBoundary::SurfaceBoundary(const TriangleMesh& surface)
  : Surface(surface)
  , Vertices(surface.vertexCount(), Part::None)
{
  const auto ends = [&surface](int a, int b) -> std::array<double, 6>
  {
    const auto& x = surface.Vertices;
    return { x(a, 0), x(a, 1), x(a, 2), x(b, 0), x(b, 1), x(b, 2) };
  };
  std::vector<std::pair<int, int>> edges;
  std::set<std::array<double, 6>> places;
  for (const std::vector<int>& loop :
    analyseTopology(surface.Faces, surface.vertexCount()).BoundaryLoops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      edges.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
      places.insert(ends(edges.back().first, edges.back().second));
      const int before = loop[(i + loop.size() - 1) % loop.size()];
      if (surface.Vertices.row(before) == surface.Vertices.row(edges.back().second))
      {
        this->Ends.emplace_back(loop[i], before); // the boundary turns round here
      }
    }
  }
  for (const auto& [a, b] : edges)
  {
    const Part part = places.count(ends(b, a)) > 0 ? Part::Seam : Part::Border;
    this->Edges[std::minmax(a, b)] = part;
    this->HasSeams |= part == Part::Seam;
    this->Vertices[a] = std::max(this->Vertices[a], part);
    this->Vertices[b] = std::max(this->Vertices[b], part);
  }
}

SurfaceBoundary::Part SurfaceBoundary::partAt(const SurfacePoint& at) const
{
  std::array<int, 3> corners{};
  int count = 0;
  for (int k = 0; k < 3; ++k)
  {
    if (at.Weights[k] > 0.0)
    {
      corners[count++] = this->Surface.Faces(at.Face, k);
    }
  }
  if (count == 1)
  {
    return this->Vertices[corners[0]];
  }
  const auto edge =
    count == 2 ? this->Edges.find(std::minmax(corners[0], corners[1])) : this->Edges.end();
  return edge == this->Edges.end() ? Part::None : edge->second;
}

bool SurfaceBoundary::hasSeamEndIn(const Eigen::Matrix3d& triangle, double tolerance) const
{
  const Eigen::Vector3d a = triangle.row(0);
  const Eigen::Vector3d u = triangle.row(1).transpose() - a;
  const Eigen::Vector3d v = triangle.row(2).transpose() - a;
  const Eigen::Vector3d normal = u.cross(v); // as long as twice the area
  const double square = normal.squaredNorm();
  const double longest = std::max({ u.norm(), v.norm(), (u - v).norm() });
  for (const auto& [last, before] : this->Ends)
  {
    const Eigen::Vector3d end = this->Surface.Vertices.row(last);
    const Eigen::Vector3d edge = this->Surface.Vertices.row(before).transpose() - end;
    if (!(square > 0.0) || (end - a).norm() > longest + tolerance + edge.norm())
    {
      continue;
    }
    for (int i = 0; i < PointsOfSeamEnd; ++i)
    {
      const Eigen::Vector3d offset = end + static_cast<double>(i) / PointsOfSeamEnd * edge - a;
      const double second = offset.cross(v).dot(normal) / square;
      const double third = u.cross(offset).dot(normal) / square;
      if (std::min({ second, third, 1.0 - second - third }) > InsideTriangle &&
          std::abs(offset.dot(normal)) <= tolerance * std::sqrt(square))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace flattening
