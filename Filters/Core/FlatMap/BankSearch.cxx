// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/BankSearch.h"

#include <limits>
#include <set>
#include <vector>

namespace flattening
{
namespace
{

// How far, in radii of the face around its centroid, a connection on the flattened surface may stray.
// Greater values cost time; with values near 1 a way through large triangles is missed.
constexpr double ConnectionReach = 2.0;

} // namespace

// The place nearest to the centroid of those that are found from the whole surface and from the places
// of the corners; the last ones are on the right side where another fold is nearer.
std::optional<SurfacePoint> BankSearch::placeOfCentroid(int face, const Eigen::Vector3d& centroid) const
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    normal += this->Search.Normals.row(this->Target.Faces(face, k)).transpose();
  }
  std::optional<SurfacePoint> nearest;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const SurfacePoint& at)
  {
    const double distance = (at.Position - centroid).norm();
    if (distance < least && normal.dot(this->Search.Walk.normal(at)) > 0.0)
    {
      least = distance;
      nearest = at;
    }
  };
  offer(this->Search.Tree.closest(centroid));
  for (int k = 0; k < 3; ++k)
  {
    const SurfacePoint& corner = this->Map.Places[this->Target.Faces(face, k)];
    offer(this->Search.Walk.closest(centroid, corner.Face));
  }
  return nearest;
}

// Whether faces that share vertices lead from one face to another within a ball.
bool BankSearch::isConnected(int from, int to, const Eigen::Vector3d& centre, double radius) const
{
  std::set<int> found{ from };
  std::vector<int> open{ from };
  while (!open.empty() && found.count(to) == 0)
  {
    const int face = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k)
    {
      const int vertex = this->Surface.Faces(face, k);
      const Eigen::Vector3d corner = this->Surface.Vertices.row(vertex);
      if (face != from && (corner - centre).norm() > radius)
      {
        continue;
      }
      for (const int next : this->Around[vertex])
      {
        if (found.insert(next).second)
        {
          open.push_back(next);
        }
      }
    }
  }
  return found.count(to) > 0;
}

PlacedFace BankSearch::place(int face) const
{
  PlacedFace result;
  const Eigen::Matrix3d corners = faceCorners(this->Target, face);
  for (int k = 0; k < 3; ++k)
  {
    if (!this->Map.Survived[this->Target.Faces(face, k)])
    {
      return result;
    }
  }
  const Eigen::Vector3d centroid = corners.colwise().mean();
  const std::optional<SurfacePoint> middle = this->placeOfCentroid(face, centroid);
  if (!middle)
  {
    return result;
  }
  const double radius = (corners.rowwise() - centroid.transpose()).rowwise().norm().maxCoeff();
  // The way round the end of a seam is so short that it looks like a connection.
  result.Result = this->Search.Boundary.hasSeamEndIn(corners, this->Map.Tolerance) ? PlacedAs::AcrossSeam
                                                                                   : PlacedAs::Placed;
  for (int k = 0; k < 3 && result.Result == PlacedAs::Placed; ++k)
  {
    const SurfacePoint& own = this->Map.Places[this->Target.Faces(face, k)];
    const SurfacePoint at = this->Search.Walk.closest(corners.row(k), middle->Face);
    if (this->OnMap.areSame(at, own))
    {
      continue;
    }
    if ((at.Position - own.Position).norm() <= this->Search.SamePlace)
    {
      result.OtherBank[k] = at;
    }
    else if (!this->OnMap.areSame(this->Search.Walk.closest(centroid, own.Face), *middle) &&
             (this->Search.Boundary.partAt(at) == SurfaceBoundary::Part::Seam ||
               !this->isConnected(middle->Face, own.Face, centroid, ConnectionReach * radius)))
    {
      result.Result = PlacedAs::AcrossSeam;
    }
  }
  return result;
}

} // namespace flattening
