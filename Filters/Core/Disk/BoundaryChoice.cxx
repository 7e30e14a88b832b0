// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/BoundaryChoice.h"

#include "Base/Errors.h"
#include "Mesh/MeshMeasures.h"
#include "Repair/HoleFilling.h"

#include <algorithm>
#include <limits>

namespace flattening
{

int chooseBoundary(const Points3& vertices,
  const std::vector<std::vector<int>>& loops,
  const BoundaryChoice& choice)
{
  if (choice.By == BoundaryChoice::Rule::None)
  {
    return -1;
  }
  if (choice.By == BoundaryChoice::Rule::ClosestToPoint && !choice.Point.allFinite())
  {
    throw InvalidInput("the boundary's point is not finite: set all of its coordinates");
  }
  int chosen = -1;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    double cost = std::numeric_limits<double>::infinity();
    if (choice.By == BoundaryChoice::Rule::Longest)
    {
      cost = -loopLength(vertices, loops[i]);
    }
    else
    {
      for (const int v : loops[i])
      {
        cost = std::min(cost, (vertices.row(v) - choice.Point.transpose()).stableNorm());
      }
    }
    if (cost < best)
    {
      best = cost;
      chosen = static_cast<int>(i);
    }
  }
  return chosen;
}

bool isPuncture(const TriangleMesh& mesh, const std::vector<int>& loop, double areaFraction)
{
  constexpr double pi = 3.14159265358979323846;
  const double length = loopLength(mesh.Vertices, loop);
  return length * length < 4.0 * pi * areaFraction * faceAreas(mesh.Vertices, mesh.Faces).sum();
}

Eigen::Vector3d centreOfLoop(const Points3& vertices, const std::vector<int>& loop)
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const int v : loop)
  {
    sum += vertices.row(v);
  }
  return sum.transpose() / static_cast<double>(loop.size());
}

} // namespace flattening
