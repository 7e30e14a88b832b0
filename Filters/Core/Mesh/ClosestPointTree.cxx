// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/ClosestPointTree.h"

#include "Base/Errors.h"
#include "Base/InterruptibleCall.h"
#include "Mesh/CgalVersions.h"
#include "Mesh/EditableSurface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace flattening
{
namespace
{

// A hundredth of the greatest double, so that sums of squares of the mesh's coordinates and of the
// point's are finite, too.
constexpr double GreatestSquare = 1e306;

using Triangles = std::vector<Kernel::Triangle_3>;

// How far a point may lie from where its weights say, as a share of the triangle's longest side. In a
// needle, rounding makes it more, up to all of the side.
constexpr double WeightError = 1e-9;

// How far @p point lies from where the weights say.
double errorOf(const std::array<double, 3>& weights,
  const Eigen::Matrix3d& corners,
  const Eigen::Vector3d& point)
{
  return (Eigen::Map<const Eigen::RowVector3d>(weights.data()) * (corners.rowwise() - point.transpose()))
    .norm();
}

// The weights of the point of the triangle's sides that is nearest to @p point.
std::array<double, 3> nearestOnSides(const Eigen::Matrix3d& corners, const Eigen::Vector3d& point)
{
  std::array<double, 3> nearest{ 1.0, 0.0, 0.0 };
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const Eigen::Vector3d side = corners.row(next) - corners.row(k);
    const double length = side.squaredNorm();
    const double along = side.dot(point - corners.row(k).transpose());
    std::array<double, 3> weights{ 0.0, 0.0, 0.0 };
    weights[next] = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
    weights[k] = 1.0 - weights[next];
    if (errorOf(weights, corners, point) < errorOf(nearest, corners, point))
    {
      nearest = weights;
    }
  }
  return nearest;
}

// Barycentric coordinates of a point of the triangle's plane. Coordinates that rounding makes negative
// become 0. In needles, where these are rounding, and in triangles without area those of the nearest
// point of a side.
std::array<double, 3> barycentric(const Eigen::Matrix3d& corners, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d u = corners.row(1) - corners.row(0);
  const Eigen::Vector3d v = corners.row(2) - corners.row(0);
  const Eigen::Vector3d normal = u.cross(v);
  const double squared = normal.squaredNorm();
  if (!(squared > 0.0))
  {
    return nearestOnSides(corners, point);
  }
  std::array<double, 3> weights{ 0.0, 0.0, 0.0 };
  const Eigen::Vector3d w = point - corners.row(0).transpose();
  weights[1] = std::max(0.0, w.cross(v).dot(normal) / squared);
  weights[2] = std::max(0.0, u.cross(w).dot(normal) / squared);
  weights[0] = std::max(0.0, 1.0 - weights[1] - weights[2]);
  const double sum = weights[0] + weights[1] + weights[2];
  for (double& weight : weights)
  {
    weight /= sum;
  }
  const double error = errorOf(weights, corners, point);
  if (error > WeightError * std::max({ u.norm(), v.norm(), (v - u).norm() }))
  {
    const std::array<double, 3> onSides = nearestOnSides(corners, point);
    return errorOf(onSides, corners, point) < error ? onSides : weights;
  }
  return weights;
}

} // namespace

struct ClosestPointTree::Tree
{
  Triangles Faces;
  TriangleTree<Kernel, Triangles::const_iterator> Boxes;
};

ClosestPointTree::ClosestPointTree(const TriangleMesh& mesh, const ProgressCallback& progress)
  : Mesh(mesh)
  , Boxes(std::make_shared<Tree>())
{
  Triangles& faces = this->Boxes->Faces;
  faces.reserve(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    faces.emplace_back(pointOf(mesh.Vertices, mesh.Faces(f, 0)),
      pointOf(mesh.Vertices, mesh.Faces(f, 1)),
      pointOf(mesh.Vertices, mesh.Faces(f, 2)));
  }
  callInterruptibly(
    [tree = this->Boxes, isComplete = static_cast<bool>(progress)]()
    {
      tree->Boxes.insert(tree->Faces.cbegin(), tree->Faces.cend());
      tree->Boxes.accelerate_distance_queries();
      if (isComplete && !tree->Faces.empty())
      {
        tree->Boxes.closest_point(tree->Faces.front()[0]); // the first query builds what is missing
      }
    },
    progress,
    0.0,
    "Building the search tree");
}

ClosestPointTree::~ClosestPointTree() = default;

bool ClosestPointTree::canSearch(const Eigen::Vector3d& point)
{
  return point.squaredNorm() <= GreatestSquare;
}

SurfacePoint ClosestPointTree::closest(const Eigen::Vector3d& point) const
{
  if (!canSearch(point)) // CGAL ends the program if a square is infinite
  {
    throw InvalidInput(
      "a point lies so far from the surface that double precision does not hold the square "
      "of its distance: set a point near the surface");
  }
  const auto [position, primitive] =
    this->Boxes->Boxes.closest_point_and_primitive({ point.x(), point.y(), point.z() });
  SurfacePoint result;
  result.Face = static_cast<int>(primitive - this->Boxes->Faces.cbegin());
  result.Position = { position.x(), position.y(), position.z() };
  result.Weights = barycentric(faceCorners(this->Mesh, result.Face), result.Position);
  return result;
}

} // namespace flattening
