// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMapLocation.h"

#include "Errors.h"

#include <string>
#include <utility>

namespace flattening
{
namespace
{

// Stricter than Rounding: in a thin face a small distance in the plane can be a large one in space.
constexpr double WalkRounding = 1e-15;

TriangleMesh flatMesh(const TriangleMesh& surface, const Points2& positions)
{
  if (positions.rows() != surface.vertexCount())
  {
    throw InvalidInput("there are " + std::to_string(positions.rows()) + " flat positions for " +
                       std::to_string(surface.vertexCount()) +
                       " vertices: pass the positions of this very surface");
  }
  TriangleMesh mesh{ Points3::Zero(positions.rows(), 3), surface.Faces };
  mesh.Vertices.leftCols<2>() = positions;
  return mesh;
}

void requireFinite(const Eigen::RowVector3d& point)
{
  if (!point.allFinite())
  {
    throw InvalidInput("a point to look up is not finite: leave it out");
  }
}

} // namespace

FlatMapLocation::Searched::Searched(TriangleMesh whole)
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
  this->Projection = std::make_unique<SurfaceProjection>(this->Mesh);
}

MapPlace FlatMapLocation::Searched::placeOf(const SurfacePoint& found,
  const Eigen::RowVector3d& point) const
{
  const double distance = (found.Position.transpose() - point).norm();
  return { this->Faces[found.Face], found.Weights, distance, distance <= Rounding * this->Diagonal };
}

MapPlace FlatMapLocation::Searched::nearest(const Eigen::RowVector3d& point) const
{
  requireFinite(point);
  return this->placeOf(this->Projection->closest(point.transpose()), point);
}

FlatMapLocation::FlatMapLocation(const TriangleMesh& surface, const Points2& positions)
  : Surface(surface)
  , Positions(positions)
  , Map(flatMesh(surface, positions))
  , MapWalk(this->Map.Mesh)
  , Space(surface)
{
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
    // The walk may end at a bay of the boundary, but never inside of the map but at the point itself.
    const MapPlace place = this->Map.placeOf(this->MapWalk.closest(inSpace.transpose(), start), inSpace);
    if (place.Distance <= WalkRounding * this->Map.Diagonal)
    {
      return place;
    }
  }
  return this->Map.nearest(inSpace);
}

MapPlace FlatMapLocation::onSurface(const Eigen::RowVector3d& point) const
{
  return this->Space.nearest(point);
}

Eigen::RowVector3d FlatMapLocation::surfacePoint(const MapPlace& place) const
{
  Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    point += place.Weights[k] * this->Surface.Vertices.row(this->Surface.Faces(place.Face, k));
  }
  return point;
}

Eigen::RowVector2d FlatMapLocation::mapPoint(const MapPlace& place) const
{
  Eigen::RowVector2d point = Eigen::RowVector2d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    point += place.Weights[k] * this->Positions.row(this->Surface.Faces(place.Face, k));
  }
  return point;
}

} // namespace flattening
