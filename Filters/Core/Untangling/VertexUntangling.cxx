// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/VertexUntangling.h"

#include "Mesh/PlaneVectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{

// Altitude that an untangled face gets, as a share of its target's altitude over the same side. A
// choice: with less, faces come out as slivers; with more, stars have no room and fall to the larger
// patches.
constexpr double AltitudeShare = 0.1;
// Number of faces above which a vertex is not moved alone: a guard, for the time grows with the square.
constexpr int LargestStar = 200;

// The points x with Inward . x >= Distance.
struct HalfPlane
{
  Eigen::Vector2d Inward; // of length 1
  double Distance;

  double excess(const Eigen::Vector2d& x) const { return this->Inward.dot(x) - this->Distance; }
};

// The point nearest to the origin on the border of the half-plane *last, within all half-planes before
// it.
std::optional<Eigen::Vector2d> nearestOnBorder(const HalfPlane* first, const HalfPlane* last)
{
  const Eigen::Vector2d foot = last->Distance * last->Inward;
  const Eigen::Vector2d along(-last->Inward.y(), last->Inward.x());
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  for (; first != last; ++first)
  {
    const double rate = first->Inward.dot(along);
    const double crossing = -first->excess(foot) / rate;
    if (rate > 0.0)
    {
      lowest = std::max(lowest, crossing);
    }
    else if (rate < 0.0)
    {
      highest = std::min(highest, crossing);
    }
    else if (first->excess(foot) < 0.0)
    {
      return std::nullopt;
    }
  }
  if (!(lowest <= highest))
  {
    return std::nullopt;
  }
  return foot + std::clamp(0.0, lowest, highest) * along;
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

// Where the vertex could go so that all of its faces are positively oriented.
std::optional<Eigen::Vector2d> positionInKernel(const UntanglingMesh& mesh, int v)
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

std::optional<Eigen::Vector2d> nearestInKernel(const Eigen::Vector2d& position,
  const std::vector<OppositeSide>& sides)
{
  std::vector<HalfPlane> halfPlanes;
  for (const OppositeSide& side : sides)
  {
    const Eigen::Vector2d along = side.Second - side.First;
    const Eigen::Vector2d inward = Eigen::Vector2d(-along.y(), along.x()) / along.norm();
    if (!inward.allFinite())
    {
      return std::nullopt;
    }
    halfPlanes.push_back({ inward, inward.dot(side.First - position) + side.Altitude });
  }
  // The half-planes are taken one by one: if the nearest point so far lies outside of the next
  // half-plane, the new nearest point lies on its border.
  Eigen::Vector2d nearest = Eigen::Vector2d::Zero();
  for (const HalfPlane& next : halfPlanes)
  {
    if (next.excess(nearest) < 0.0)
    {
      const std::optional<Eigen::Vector2d> onBorder = nearestOnBorder(halfPlanes.data(), &next);
      if (!onBorder)
      {
        return std::nullopt;
      }
      nearest = *onBorder;
    }
  }
  return position + nearest;
}

bool untangleByOneVertex(UntanglingMesh& mesh, int f)
{
  int best = -1;
  Eigen::RowVector2d bestPosition;
  double leastMove = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
  {
    const int v = mesh.Faces(f, k);
    const std::optional<Eigen::Vector2d> position = positionInKernel(mesh, v);
    if (!position)
    {
      continue;
    }
    const Eigen::RowVector2d old = mesh.Positions.row(v);
    const double move = (position->transpose() - old).norm() / mesh.edgeLengthAt(v);
    mesh.Positions.row(v) = position->transpose();
    const bool works = starIsPositive(mesh, v);
    mesh.Positions.row(v) = old;
    if (works && move < leastMove)
    {
      best = v;
      bestPosition = position->transpose();
      leastMove = move;
    }
  }
  if (best >= 0)
  {
    mesh.Positions.row(best) = bestPosition;
  }
  return best >= 0;
}

} // namespace flattening
