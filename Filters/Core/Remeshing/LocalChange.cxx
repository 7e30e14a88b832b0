// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/LocalChange.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

// The smallest cosine between the triangle's normal and one of the old surface's normals at its corners;
// -1 if the triangle has no area.
double alignment(const CornerTriangle& triangle)
{
  const Eigen::Vector3d areaVector =
    (*triangle[1].Position - *triangle[0].Position).cross(*triangle[2].Position - *triangle[0].Position);
  const double length = areaVector.norm();
  const double smallest = std::min({ areaVector.dot(*triangle[0].Normal),
    areaVector.dot(*triangle[1].Normal),
    areaVector.dot(*triangle[2].Normal) });
  return length > 0.0 ? smallest / length : -1.0;
}

} // namespace

double smallestSine(const CornerTriangle& triangle)
{
  const Eigen::Vector3d u = *triangle[1].Position - *triangle[0].Position;
  const Eigen::Vector3d v = *triangle[2].Position - *triangle[1].Position;
  const Eigen::Vector3d w = *triangle[0].Position - *triangle[2].Position;
  const std::array<double, 3> squares{ u.squaredNorm(), v.squaredNorm(), w.squaredNorm() };
  const double shortest = std::min({ squares[0], squares[1], squares[2] });
  const double longest = std::max({ squares[0], squares[1], squares[2] });
  const double middle = squares[0] + squares[1] + squares[2] - shortest - longest;
  return middle > 0.0 ? std::sqrt(u.cross(v).squaredNorm() / (middle * longest)) : 0.0;
}

double smallestSine(const LocalChange::Triangles& triangles)
{
  double smallest = 1.0;
  for (const CornerTriangle& triangle : triangles)
  {
    smallest = std::min(smallest, smallestSine(triangle));
  }
  return smallest;
}

double smallestAlignment(const LocalChange::Triangles& triangles)
{
  double smallest = 1.0;
  for (const CornerTriangle& triangle : triangles)
  {
    smallest = std::min(smallest, alignment(triangle));
  }
  return smallest;
}

} // namespace flattening
