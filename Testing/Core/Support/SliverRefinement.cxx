// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/SliverRefinement.h"

#include "Mesh/MeshMeasures.h"
#include "Support/RandomNumbers.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace flattening::samples
{
namespace
{

double smallestAngle(const Eigen::RowVector3d& a,
  const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c)
{
  const auto angle = [](const Eigen::RowVector3d& u, const Eigen::RowVector3d& v)
  { return std::atan2(u.cross(v).norm(), u.dot(v)); };
  const double smallest = std::min({ angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c) });
  return smallest * 180.0 / EIGEN_PI;
}

// Barycentric coordinates of a random point near a side or a corner, at the nearest as far off as the
// least angle allows.
Eigen::RowVector3d closePoint(RandomNumbers& random, double leastAngle)
{
  const double nearest = std::log10(leastAngle * EIGEN_PI / 180.0);
  const double distance = std::pow(10.0, random.real(nearest, -1.0));
  const double share = random.real(0.05, 0.95);
  if (random.chance(0.5))
  {
    return { (1.0 - distance) * share, (1.0 - distance) * (1.0 - share), distance };
  }
  return { 1.0 - distance, distance * share, distance * (1.0 - share) };
}

} // namespace

TriangleMesh withRandomSlivers(const TriangleMesh& mesh,
  int splits,
  double leastAngle,
  std::uint64_t seed)
{
  RandomNumbers random(seed);
  TriangleMesh fine = mesh;
  fine.Vertices.conservativeResize(mesh.vertexCount() + splits, 3);
  fine.Faces.conservativeResize(mesh.faceCount() + 2 * splits, 3);
  int vertexCount = mesh.vertexCount();
  int faceCount = mesh.faceCount();
  while (vertexCount < fine.vertexCount())
  {
    const int f = random.integer(0, faceCount - 1);
    const int first = random.integer(0, 2);
    const int a = fine.Faces(f, first);
    const int b = fine.Faces(f, (first + 1) % 3);
    const int c = fine.Faces(f, (first + 2) % 3);
    const Eigen::RowVector3d weights = closePoint(random, leastAngle);
    const Eigen::RowVector3d at = fine.Vertices.row(a);
    const Eigen::RowVector3d point =
      at + weights[1] * (fine.Vertices.row(b) - at) + weights[2] * (fine.Vertices.row(c) - at);
    if (std::min({ smallestAngle(fine.Vertices.row(a), fine.Vertices.row(b), point),
          smallestAngle(fine.Vertices.row(b), fine.Vertices.row(c), point),
          smallestAngle(fine.Vertices.row(c), fine.Vertices.row(a), point) }) < leastAngle)
    {
      continue;
    }
    fine.Vertices.row(vertexCount) = point;
    fine.Faces.row(f) << a, b, vertexCount;
    fine.Faces.row(faceCount) << b, c, vertexCount;
    fine.Faces.row(faceCount + 1) << c, a, vertexCount;
    ++vertexCount;
    faceCount += 2;
  }
  return fine;
}

double smallestAngleOf(const TriangleMesh& mesh)
{
  double smallest = 180.0;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    smallest = std::min(smallest,
      smallestAngle(mesh.Vertices.row(mesh.Faces(f, 0)),
        mesh.Vertices.row(mesh.Faces(f, 1)),
        mesh.Vertices.row(mesh.Faces(f, 2))));
  }
  return smallest;
}

} // namespace flattening::samples
