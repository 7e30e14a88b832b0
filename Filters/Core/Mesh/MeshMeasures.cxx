// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshMeasures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace flattening
{

double loopLength(const Points3& vertices, const std::vector<int>& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += (vertices.row(loop[i]) - vertices.row(loop[(i + 1) % loop.size()])).norm();
  }
  return length;
}

double meanEdgeLength(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      sum +=
        (mesh.Vertices.row(mesh.Faces(f, k)) - mesh.Vertices.row(mesh.Faces(f, (k + 1) % 3))).norm();
    }
  }
  return sum / (3.0 * mesh.faceCount());
}

double smallestAngle(const TriangleMesh& mesh)
{
  constexpr double degrees = 180.0 / EIGEN_PI;
  double smallest = 180.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d apex = mesh.Vertices.row(mesh.Faces(f, k));
      const Eigen::Vector3d u = mesh.Vertices.row(mesh.Faces(f, (k + 1) % 3)).transpose() - apex;
      const Eigen::Vector3d v = mesh.Vertices.row(mesh.Faces(f, (k + 2) % 3)).transpose() - apex;
      smallest = std::min(smallest, degrees * std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  }
  return smallest;
}

} // namespace flattening
