// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/VertexUntangling.h"

#include "Untangling/StarKernel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace flattening
{
namespace
{

// Of the target's, over the same side.
constexpr double AltitudeShare = 0.1;
// A vertex with more faces is left where it is.
constexpr int LargestStar = 200;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

OppositeSide oppositeSide(const UntanglingMesh& mesh, int f, int corner)
{
  const TargetTriangle target = mesh.Targets(f);
  const Eigen::Vector2d targetCorners[3] = { { 0.0, 0.0 }, target.Second, target.Third };
  const int first = (corner + 1) % 3;
  const int second = (corner + 2) % 3;
  OppositeSide side;
  side.First = mesh.Positions.row(mesh.Faces(f, first)).transpose();
  side.Second = mesh.Positions.row(mesh.Faces(f, second)).transpose();
  const Eigen::Vector2d along = side.Second - side.First;
  const double length = along.norm();
  const double slope =
    cross(target.Second, target.Third) / (targetCorners[second] - targetCorners[first]).squaredNorm();
  side.Altitude = AltitudeShare * slope * length;
  if (mesh.safelyPositive(f))
  {
    const Eigen::Vector2d vertex = mesh.Positions.row(mesh.Faces(f, corner)).transpose();
    side.Altitude = std::min(side.Altitude, cross(along, vertex - side.First) / length);
  }
  return side;
}

std::optional<Eigen::Vector2d> placeInKernel(const UntanglingMesh& mesh, int v)
{
  if (mesh.Fixed[v] || mesh.FacesOf[v].size() > LargestStar)
  {
    return std::nullopt;
  }
  std::vector<OppositeSide> sides;
  for (const int f : mesh.FacesOf[v])
  {
    int corner = 0;
    while (mesh.Faces(f, corner) != v)
    {
      ++corner;
    }
    sides.push_back(oppositeSide(mesh, f, corner));
  }
  return nearestInKernel(mesh.Positions.row(v).transpose(), sides);
}

bool starIsPositive(const UntanglingMesh& mesh, int v)
{
  const auto faces = mesh.FacesOf[v];
  return std::all_of(faces.begin(), faces.end(), [&mesh](int f) { return mesh.safelyPositive(f); });
}

} // namespace

int untangleByOneVertex(UntanglingMesh& mesh, int f)
{
  int best = -1;
  Eigen::RowVector2d bestPlace;
  double leastMove = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
  {
    const int v = mesh.Faces(f, k);
    const std::optional<Eigen::Vector2d> place = placeInKernel(mesh, v);
    if (!place)
    {
      continue;
    }
    const Eigen::RowVector2d old = mesh.Positions.row(v);
    const double move = (place->transpose() - old).norm() / mesh.edgeLengthAt(v);
    mesh.Positions.row(v) = place->transpose();
    const bool works = starIsPositive(mesh, v);
    mesh.Positions.row(v) = old;
    if (works && move < leastMove)
    {
      best = v;
      bestPlace = place->transpose();
      leastMove = move;
    }
  }
  if (best >= 0)
  {
    mesh.Positions.row(best) = bestPlace;
  }
  return best;
}

} // namespace flattening
