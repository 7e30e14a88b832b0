// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/BoundaryChoice.h"

#include "Base/Errors.h"
#include "Mesh/MeshMeasures.h"
#include "Repair/HoleFilling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{

// The area of a circle as long as the longest loop that is filled unasked, as a share of the surface's
// area. A convention: longer loops are errors, as a patch there would be a large part of the surface.
constexpr double FilledAreaShare = 0.05;

// The length of the circle around a share of the surface's area, squared.
double squaredCircle(const TriangleMesh& mesh, double share)
{
  constexpr double pi = 3.14159265358979323846;
  return 4.0 * pi * share * faceAreas(mesh.Vertices, mesh.Faces).sum();
}

} // namespace

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

double longestFilledUnasked(const TriangleMesh& mesh)
{
  return std::sqrt(squaredCircle(mesh, FilledAreaShare));
}

bool isPuncture(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  double areaFraction,
  double longestFilled)
{
  const double length = loopLength(mesh.Vertices, loop);
  return length <= longestFilled && length * length < squaredCircle(mesh, areaFraction);
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
