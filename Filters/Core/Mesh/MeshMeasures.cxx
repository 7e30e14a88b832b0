// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshMeasures.h"

#include <Eigen/Geometry>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

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
  const auto smallestIn = [&mesh](const tbb::blocked_range<int>& faces, double smallest)
  {
    for (int f = faces.begin(); f < faces.end(); ++f)
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
  };
  return tbb::parallel_reduce(tbb::blocked_range<int>(0, mesh.faceCount()),
    180.0,
    smallestIn,
    [](double a, double b) { return std::min(a, b); });
}

} // namespace flattening
