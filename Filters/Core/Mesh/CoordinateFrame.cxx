// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/CoordinateFrame.h"

#include "Base/Errors.h"
#include "Mesh/MeshMeasures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace flattening
{
namespace
{

// Surfaces of 2^-64 to 2^64 units keep their coordinates: fourth powers, the highest that occur, are
// then below 2^256 and above 2^-256.
constexpr int LargestExponent = 32;
// Surfaces no farther from the origin, in their own sizes, keep their place: three of sixteen digits.
constexpr double LargestOffset = 1000.0;
// The extent below which coordinates have fewer digits than double precision (they are subnormal, or
// about to be when they are subtracted), and the one above which their differences overflow.
constexpr double SmallestSize = 1e-290;
constexpr double LargestSize = 0.25 * std::numeric_limits<double>::max();
// The largest distance of two neighbouring doubles, as a share of the mean edge length. The faces along
// a cut have about a thousandth of the mean edge, and rounding changes their lengths by a hundredth
// then.
constexpr double LargestSpacing = 1e-5;

using Bounds = Eigen::AlignedBox3d;

double sizeOf(const Bounds& bounds)
{
  return bounds.sizes().maxCoeff();
}

// The largest coordinate.
double distanceOf(const Bounds& bounds)
{
  return std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff());
}

Bounds boundsOfFaces(const TriangleMesh& mesh)
{
  Bounds bounds;
  for (const int v : mesh.Faces.reshaped())
  {
    if (v >= 0 && v < mesh.vertexCount() && mesh.Vertices.row(v).allFinite())
    {
      bounds.extend(mesh.Vertices.row(v).transpose());
    }
  }
  return bounds;
}

// A number whose differences to all numbers of the interval are exact; 0 if the interval is not far off.
double exactOrigin(double low, double high)
{
  if (low > 0.0 && 0.5 * high <= low)
  {
    return low;
  }
  return high < 0.0 && 0.5 * low >= high ? high : 0.0;
}

void requireSize(double size)
{
  if (size >= SmallestSize && size <= LargestSize)
  {
    return;
  }
  std::ostringstream message;
  message << "the surface extends over " << size << " units, "
          << (size < SmallestSize ? "too few" : "too many")
          << " for double precision: scale it, e.g. with Transform";
  throw InvalidInput(message.str());
}

void requireResolved(const Bounds& bounds, double meanEdge)
{
  const double spacing = std::numeric_limits<double>::epsilon() * distanceOf(bounds);
  if (spacing > LargestSpacing * meanEdge)
  {
    std::ostringstream message;
    message
      << "the surface lies " << distanceOf(bounds) / sizeOf(bounds)
      << " times its size away from the origin, where double precision cannot hold points between "
         "its vertices: move it to the origin where it is made, before its coordinates are rounded";
    throw InvalidInput(message.str());
  }
}

// 0 for sizes at which products of coordinates neither overflow nor underflow.
int exponentOf(double size)
{
  const int exponent = size > 0.0 && std::isfinite(size) ? std::ilogb(size) : 0;
  return std::abs(exponent) > LargestExponent ? exponent : 0;
}

} // namespace

CoordinateFrame::CoordinateFrame(const TriangleMesh& mesh)
{
  const Bounds bounds = boundsOfFaces(mesh);
  if (bounds.isEmpty() || sizeOf(bounds) == 0.0)
  {
    return; // other checks name such surfaces
  }
  requireSize(sizeOf(bounds));
  this->Exponent = exponentOf(sizeOf(bounds));
  if (distanceOf(bounds) > LargestOffset * sizeOf(bounds))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Origin[axis] = exactOrigin(bounds.min()[axis], bounds.max()[axis]);
    }
    requireResolved(bounds, this->restoredLength(meanEdgeLength(this->normalised(mesh))));
  }
}

TriangleMesh CoordinateFrame::normalised(const TriangleMesh& mesh) const
{
  TriangleMesh result = mesh;
  for (auto vertex : result.Vertices.rowwise())
  {
    vertex = this->normalisedPoint(vertex.transpose()).transpose();
  }
  return result;
}

Eigen::Vector3d CoordinateFrame::normalisedPoint(const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d moved = point - this->Origin;
  return moved.unaryExpr([this](double x) { return this->normalisedLength(x); });
}

double CoordinateFrame::normalisedLength(double length) const
{
  return std::ldexp(length, -this->Exponent);
}

Points3 CoordinateFrame::restored(const Points3& points) const
{
  Points3 result(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    result.row(i) = this->restoredPoint(points.row(i).transpose()).transpose();
  }
  return result;
}

Eigen::Vector3d CoordinateFrame::restoredPoint(const Eigen::Vector3d& point) const
{
  return point.unaryExpr([this](double x) { return this->restoredLength(x); }) + this->Origin;
}

double CoordinateFrame::restoredLength(double length) const
{
  return std::ldexp(length, this->Exponent);
}

double CoordinateFrame::restoredArea(double area) const
{
  return std::ldexp(area, 2 * this->Exponent);
}

PlaneFrame::PlaneFrame(const Points2& positions)
  : Exponent(exponentOf(positions.size() > 0 ? positions.cwiseAbs().maxCoeff() : 0.0))
{
}

Points2 PlaneFrame::normalised(const Points2& positions) const
{
  return positions.unaryExpr([this](double x) { return std::ldexp(x, -this->Exponent); });
}

Eigen::Vector2d PlaneFrame::restoredPoint(const Eigen::Vector2d& point) const
{
  return point.unaryExpr([this](double x) { return this->restoredLength(x); });
}

double PlaneFrame::restoredLength(double length) const
{
  return std::ldexp(length, this->Exponent);
}

double PlaneFrame::restoredArea(double area) const
{
  return std::ldexp(area, 2 * this->Exponent);
}

} // namespace flattening
