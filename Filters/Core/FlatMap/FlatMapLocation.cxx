// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/FlatMapLocation.h"

#include "Base/Errors.h"

#include <algorithm>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

// The barycentric weights of a point of the plane, from the areas that it cuts off: the projections of a
// walk lose these in thin triangles. Negative where the point is outside.
std::array<double, 3> planarWeights(const TriangleMesh& mesh, int face, const Eigen::RowVector3d& point)
{
  std::array<Eigen::RowVector3d, 3> to;
  for (int k = 0; k < 3; ++k)
  {
    to[k] = mesh.Vertices.row(mesh.Faces(face, k)) - point;
  }
  std::array<double, 3> weights;
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::RowVector3d& a = to[(k + 1) % 3];
    const Eigen::RowVector3d& b = to[(k + 2) % 3];
    weights[k] = a.x() * b.y() - a.y() * b.x();
  }
  const double sum = weights[0] + weights[1] + weights[2];
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

TriangleMesh flatMesh(const TriangleMesh& surface, const Points2& positions)
{
  if (positions.rows() != surface.vertexCount())
  {
    throw InvalidInput("there are " + std::to_string(positions.rows()) + " flat positions for " +
                       std::to_string(surface.vertexCount()) +
                       " vertices: pass the positions of this very surface");
  }
  return planarMesh(positions, surface.Faces);
}

// The position of a place, for vertices at the given positions.
template <typename Positions>
auto interpolated(const Positions& positions, const FaceMatrix& faces, const MapPlace& place)
{
  Eigen::Matrix<double, 1, Positions::ColsAtCompileTime> point;
  point.setZero();
  for (int k = 0; k < 3; ++k)
  {
    point += place.Weights[k] * positions.row(faces(place.Face, k));
  }
  return point;
}

void requireFinite(const Eigen::RowVector3d& point)
{
  if (!point.allFinite())
  {
    throw InvalidInput("a point to look up is not finite: leave it out");
  }
}

} // namespace

TriangleMesh planarMesh(const Points2& positions, const FaceMatrix& faces)
{
  TriangleMesh mesh{ Points3::Zero(positions.rows(), 3), faces };
  mesh.Vertices.leftCols<2>() = positions;
  return mesh;
}

FlatMapLocation::Searched::Searched(TriangleMesh whole, const ProgressCallback& progress)
  : Mesh(std::move(whole))
{
  if (!this->Mesh.Vertices.allFinite())
  {
    throw InvalidInput(
      "the flat map or its surface has a coordinate that is not finite: flatten it again");
  }
  this->NumberOf.assign(this->Mesh.faceCount(), -1);
  const Eigen::VectorXd areas = faceAreas(this->Mesh.Vertices, this->Mesh.Faces);
  for (int f = 0; f < this->Mesh.faceCount(); ++f)
  {
    if (areas[f] > 0.0)
    {
      this->Mesh.Faces.row(static_cast<Eigen::Index>(this->Faces.size())) =
        this->Mesh.Faces.row(f).eval();
      this->NumberOf[f] = static_cast<int>(this->Faces.size());
      this->Faces.push_back(f);
    }
  }
  if (this->Faces.empty())
  {
    throw InvalidInput("the flat map or its surface has no area: flatten a surface that has");
  }
  this->Mesh.Faces.conservativeResize(static_cast<Eigen::Index>(this->Faces.size()), 3);
  this->Diagonal =
    (this->Mesh.Vertices.colwise().maxCoeff() - this->Mesh.Vertices.colwise().minCoeff()).norm();
  this->Projection = std::make_unique<ClosestPointTree>(this->Mesh, progress);
}

MapPlace FlatMapLocation::Searched::nearest(const Eigen::RowVector3d& point) const
{
  requireFinite(point);
  const SurfacePoint found = this->Projection->closest(point.transpose());
  const double distance = (found.Position.transpose() - point).norm();
  return { this->Faces[found.Face], found.Weights, distance, distance <= Rounding * this->Diagonal };
}

FlatMapLocation::FlatMapLocation(const TriangleMesh& surface,
  const Points2& positions,
  const ProgressCallback& progress)
  : Surface(surface)
  , Positions(positions)
  , Map(flatMesh(surface, positions), progress)
  , MapWalk(this->Map.Mesh)
{
  if (!surface.Vertices.allFinite())
  {
    throw InvalidInput(
      "the surface of the flat map has a coordinate that is not finite: flatten it again");
  }
}

MapPlace FlatMapLocation::onMap(const Eigen::RowVector2d& point) const
{
  return this->Map.nearest({ point.x(), point.y(), 0.0 });
}

MapPlace FlatMapLocation::onMap(const Eigen::RowVector2d& point, int nearFace) const
{
  const Eigen::RowVector3d inSpace(point.x(), point.y(), 0.0);
  requireFinite(inSpace);
  const int start = this->Map.NumberOf[nearFace];
  if (start >= 0)
  {
    const int found = this->MapWalk.closest(inSpace.transpose(), start).Face;
    const std::array<double, 3> weights = planarWeights(this->Map.Mesh, found, inSpace);
    if (*std::min_element(weights.begin(), weights.end()) >= 0.0)
    {
      return { this->Map.Faces[found], weights, 0.0, true };
    }
  }
  return this->Map.nearest(inSpace);
}

void FlatMapLocation::prepareSurface(const ProgressCallback& progress) const
{
  std::call_once(
    this->SpaceSearched, [&] { this->Space = std::make_unique<Searched>(this->Surface, progress); });
}

MapPlace FlatMapLocation::onSurface(const Eigen::RowVector3d& point) const
{
  this->prepareSurface({});
  return this->Space->nearest(point);
}

Eigen::RowVector3d FlatMapLocation::surfacePoint(const MapPlace& place) const
{
  return interpolated(this->Surface.Vertices, this->Surface.Faces, place);
}

Eigen::RowVector2d FlatMapLocation::mapPoint(const MapPlace& place) const
{
  return interpolated(this->Positions, this->Surface.Faces, place);
}

} // namespace flattening
