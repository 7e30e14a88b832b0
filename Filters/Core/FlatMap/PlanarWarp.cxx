// SPDX-License-Identifier: GPL-3.0-or-later
#include "FlatMap/PlanarWarp.h"

#include "Base/Errors.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/FaceOrientation.h"
#include "Mesh/MeshMeasures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>

namespace flattening
{
namespace
{

// The greatest extent in z of a planar mesh, as a share of the larger extent: above the rounding of
// single precision, about 1e-7; a surface in space exceeds it by far.
constexpr double Planarity = 1e-6;

// The number of points between two reports of progress, at which an abort is noticed.
constexpr Eigen::Index WarpedBatch = 1 << 14;

} // namespace

double planeHeight(const TriangleMesh& mesh)
{
  if (mesh.faceCount() == 0)
  {
    throw InvalidInput("the planar mesh has no triangles: pass the output of OMT Area Preserving");
  }
  if (!mesh.Vertices.allFinite())
  {
    throw InvalidInput("a point of the planar mesh is not finite: flatten it again");
  }
  const Eigen::RowVector3d low = mesh.Vertices.colwise().minCoeff();
  const Eigen::RowVector3d size = mesh.Vertices.colwise().maxCoeff() - low;
  if (size.z() > Planarity * std::max(size.x(), size.y()))
  {
    throw InvalidInput("the mesh was not planar before it was flattened (z has a range of " +
                       formatted(size.z()) + ", x and y of " + formatted(size.x()) + " and " +
                       formatted(size.y()) + "): pass the flat map of a mesh in a plane of constant z");
  }
  return low.z() + 0.5 * size.z();
}

namespace
{

// Whether all faces are oriented clockwise.
bool facesDownAll(const TriangleMesh& mesh)
{
  const std::vector<signed char> orientations =
    faceOrientations(mesh.Vertices.leftCols<2>(), mesh.Faces);
  const auto up = std::count(orientations.begin(), orientations.end(), 1);
  const auto down = std::count(orientations.begin(), orientations.end(), -1);
  if (up > 0 && down > 0)
  {
    const auto rare = std::find(orientations.begin(), orientations.end(), up < down ? 1 : -1);
    throw InvalidInput("the mesh folds over itself before it is deformed (" +
                       std::to_string(std::min(up, down)) + " of its triangles, such as " +
                       std::to_string(rare - orientations.begin()) +
                       ", face the other way): pass a mesh that covers every place once");
  }
  return down > 0;
}

double diagonal(const Points2& positions)
{
  return (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).norm();
}

// @param locate gives the place of a point on the mesh.
// @param position gives the position of a place in the other shape of the mesh.
template <typename Locate, typename Position>
WarpedPoints warped(const Points2& points,
  double tolerance,
  const ProgressCallback& progress,
  Locate&& locate,
  Position&& position)
{
  WarpedPoints result{ points, std::vector<char>(points.rows(), 0) };
  for (Eigen::Index begin = 0; begin < points.rows(); begin += WarpedBatch)
  {
    report(progress, static_cast<double>(begin) / static_cast<double>(points.rows()), "Warping points");
    tbb::parallel_for(begin,
      std::min(begin + WarpedBatch, points.rows()),
      [&](Eigen::Index i)
      {
        if (ClosestPointTree::canSearch({ points(i, 0), points(i, 1), 0.0 }))
        {
          const MapPlace place = locate(points.row(i));
          if (place.Distance <= tolerance)
          {
            result.Inside[i] = 1;
            result.Positions.row(i) = position(place);
          }
        }
      });
  }
  report(progress, 1.0, "Warping points");
  return result;
}

} // namespace

PlanarWarp::PlanarWarp(const TriangleMesh& mesh,
  const Points2& positions,
  const ProgressCallback& progress)
  : PlaneHeight(flattening::planeHeight(mesh))
  , FacesDown(facesDownAll(mesh))
  , MeanSide(meanEdgeLength(mesh))
  , Diagonals{ diagonal(mesh.Vertices.leftCols<2>()), diagonal(positions) }
  , Location(mesh, positions, progress)
{
}

WarpedPoints PlanarWarp::warp(const Points2& points, const ProgressCallback& progress) const
{
  this->Location.prepareSurface(subrange(progress, 0.0, 0.3));
  return warped(
    points,
    Rounding * this->Diagonals[0],
    subrange(progress, 0.3, 1.0),
    [this](const Eigen::RowVector2d& point) {
      return this->Location.onSurface({ point.x(), point.y(), this->PlaneHeight });
    },
    [this](const MapPlace& place) { return this->Location.mapPoint(place); });
}

WarpedPoints PlanarWarp::warpBack(const Points2& points, const ProgressCallback& progress) const
{
  return warped(
    points,
    Rounding * this->Diagonals[1],
    progress,
    [this](const Eigen::RowVector2d& point) { return this->Location.onMap(point); },
    [this](const MapPlace& place) -> Eigen::RowVector2d
    { return this->Location.surfacePoint(place).head<2>(); });
}

} // namespace flattening
