// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/FlatDomain.h"

#include "Core/Base/Errors.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace flattening
{
namespace
{

// The distance from the sides of a rectangle, or from a plane, that is rounding, as a share of the
// extent: above the rounding of single precision, about 1e-7, and far below the distance of a circle
// from the sides of its bounding box.
constexpr double Tolerance = 1e-6;

// The mean distance of the boundary vertices from the origin: the radius of the disk.
double diskRadius(const Points2& positions, const std::vector<int>& loop)
{
  double sum = 0.0;
  for (const int v : loop)
  {
    sum += positions.row(v).norm();
  }
  const double radius = sum / loop.size();
  if (!(radius > 0.0))
  {
    throw InvalidInput("the boundary of the flat surface is a single point: run Conformal Disk first");
  }
  return radius;
}

// Finds the points of the only polygon or line.
void outlinePoints(vtkPolyData* data, vtkIdList* ids)
{
  const vtkIdType polygons = data->GetNumberOfPolys();
  const vtkIdType lines = data->GetNumberOfLines();
  if (data->GetNumberOfStrips() > 0 || polygons > 1 || (polygons == 0 && lines != 1))
  {
    throw InvalidInput("the domain has " + std::to_string(polygons) + " polygons, " +
                       std::to_string(lines) + " lines and " +
                       std::to_string(data->GetNumberOfStrips()) +
                       " strips: give one convex polygon or one closed line");
  }
  vtkCellArray* cells = polygons == 1 ? data->GetPolys() : data->GetLines();
  cells->GetCellAtId(0, ids);
  for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
  {
    if (ids->GetId(k) < 0 || ids->GetId(k) >= data->GetNumberOfPoints())
    {
      throw InvalidInput("the domain names point " + std::to_string(ids->GetId(k)) +
                         ", which does not exist: the data set is damaged");
    }
  }
}

// Whether the boundary lies on the sides of the box between two corners, and has a vertex in each
// corner.
bool isRectangle(const Points2& positions,
  const std::vector<int>& loop,
  const Eigen::RowVector2d& low,
  const Eigen::RowVector2d& high,
  double slack)
{
  bool hasCorner[2][2] = { { false, false }, { false, false } };
  for (const int v : loop)
  {
    const Eigen::RowVector2d fromLow = positions.row(v) - low;
    const Eigen::RowVector2d fromHigh = high - positions.row(v);
    if (std::min(fromLow.minCoeff(), fromHigh.minCoeff()) > slack)
    {
      return false;
    }
    const Eigen::RowVector2d nearest = fromLow.cwiseMin(fromHigh);
    if (nearest.maxCoeff() <= slack)
    {
      hasCorner[fromHigh.x() < fromLow.x()][fromHigh.y() < fromLow.y()] = true;
    }
  }
  return (high - low).minCoeff() > slack && hasCorner[0][0] && hasCorner[0][1] && hasCorner[1][0] &&
         hasCorner[1][1];
}

// Whether the boundary lies on a circle around the origin, as that of a disk with four vertices may do
// which are the corners of a rectangle.
bool isCircle(const Points2& positions, const std::vector<int>& loop, double slack)
{
  const double radius = positions.row(loop.front()).norm();
  return std::all_of(loop.begin(),
    loop.end(),
    [&](int v) { return std::abs(positions.row(v).norm() - radius) <= slack; });
}

} // namespace

std::shared_ptr<const ConvexDomain> FlatDomain::normalised() const
{
  if (!this->IsRectangle)
  {
    return std::make_shared<UnitDisk>();
  }
  const double x = 0.5 * this->Width / this->Scale;
  const double y = 0.5 * this->Height / this->Scale;
  Points2 corners(4, 2);
  corners << -x, -y, x, -y, x, y, -x, y;
  return std::make_shared<ConvexPolygon>(corners);
}

FlatDomain flatDomain(const Points2& positions, const std::vector<int>& loop)
{
  Eigen::RowVector2d low = positions.row(loop.front());
  Eigen::RowVector2d high = low;
  for (const int v : loop)
  {
    low = low.cwiseMin(positions.row(v));
    high = high.cwiseMax(positions.row(v));
  }
  const double slack = Tolerance * (high - low).norm();
  FlatDomain domain;
  domain.IsRectangle =
    isRectangle(positions, loop, low, high, slack) && !isCircle(positions, loop, slack);
  if (domain.IsRectangle)
  {
    domain.Centre = 0.5 * (low + high);
    domain.Width = high.x() - low.x();
    domain.Height = high.y() - low.y();
    domain.Scale = std::sqrt(domain.Width * domain.Height / EIGEN_PI);
    return domain;
  }
  domain.Scale = diskRadius(positions, loop);
  return domain;
}

Points2 polygonOutline(vtkPolyData* data)
{
  vtkNew<vtkIdList> ids;
  outlinePoints(data, ids);
  Points3 points(ids->GetNumberOfIds(), 3);
  for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
  {
    data->GetPoint(ids->GetId(k), points.row(k).data());
  }
  const bool isLine = data->GetNumberOfPolys() == 0;
  const bool isClosed = points.rows() > 0 && points.row(0) == points.row(points.rows() - 1);
  if (isLine && !isClosed)
  {
    throw InvalidInput("the domain's line does not end where it begins: close it, or give a polygon");
  }
  if (points.rows() > 0 && points.allFinite())
  {
    const Eigen::RowVector3d extent = points.colwise().maxCoeff() - points.colwise().minCoeff();
    if (extent.z() > Tolerance * std::max(extent.x(), extent.y()))
    {
      throw InvalidInput("the domain does not lie in a plane of constant z (its z extends over " +
                         formatted(extent.z()) + "): turn it into the xy plane");
    }
  }
  return points.leftCols<2>();
}

} // namespace flattening
