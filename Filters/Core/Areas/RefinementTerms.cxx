// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/RefinementTerms.h"

#include "Mesh/SliverThresholds.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <unordered_set>

namespace flattening
{
namespace
{

// The least share of an interval, in mean intervals. A guard for boundary edges without length on the
// surface.
constexpr double LeastInterval = 1e-3;
// Intervals that are shorter than this, in mean intervals, have a limit. A choice: longer ones are kept
// by the shapes of their faces, and are to follow the areas.
constexpr double TinyInterval = 0.2;
// The weight of their stretch beyond the limit against areas, per square of a mean interval. A choice:
// of 1,404 edges along the seam of a brain, 7 are stretched more than ten times without a limit, up to
// 98 times. With 0.001, 0.01 and 0.1 (for intervals of any length) these are 5, none and none, and angle
// errors stay the same.
constexpr double WeightOfLimit = 0.01;
// The shape limit (FaceAreaEnergy) of faces with two vertices on a free boundary. Without it a point
// with few faces may stick out as a needle, which the logarithm lets go and the areas then hold. A
// choice: on the map of a cortex the longest edge has 13.3 mean edges without a limit, 4.4 with 3, 2.3
// with 2 and 2.6 with 1.5, and mean angle errors stay the same. With a limit of 3 for all faces, that of
// half a brain is 8.5 instead of 8.35 degrees.
constexpr double OutlineShapeLimit = 2.0;

} // namespace

RefinementTerms::RefinementTerms(const TriangleMesh& surface,
  const std::vector<int>& loop,
  double perimeter,
  double shapeWeight)
  : Faces(surface.Faces)
  , Cotangents(surface.faceCount(), 3)
  , ShapeWeights(surface.faceCount())
  , ShapeLimits(Eigen::VectorXd::Constant(surface.faceCount(), std::numeric_limits<double>::infinity()))
{
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    Eigen::Vector3d corners[3];
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = surface.Vertices.row(surface.Faces(f, k));
    }
    double longest2 = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      longest2 = std::max(longest2, (corners[(k + 1) % 3] - corners[k]).squaredNorm());
    }
    const double twiceArea = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    const double altitude = longest2 > 0.0 ? twiceArea / longest2 : 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double cosine = (corners[(k + 1) % 3] - corners[k]).dot(corners[(k + 2) % 3] - corners[k]);
      this->Cotangents(f, k) =
        longest2 > 0.0 ? cosine / std::max(twiceArea, slivers::AngleAltitude * longest2) : 0.0;
    }
    const double share = std::min(1.0, altitude / slivers::ShapeAltitude);
    this->ShapeWeights[f] = shapeWeight * share * share;
  }
  const int members = static_cast<int>(loop.size());
  double length = 0.0;
  for (int k = 0; k < members; ++k)
  {
    const int next = (k + 1) % members;
    const double interval = (surface.Vertices.row(loop[next]) - surface.Vertices.row(loop[k])).norm();
    this->Intervals.push_back({ k, next, interval });
    length += interval;
  }
  double sum = 0.0;
  for (BoundaryInterval& interval : this->Intervals)
  {
    interval.Share = std::max(interval.Share, LeastInterval * length / members);
    sum += interval.Share;
  }
  const double mean = perimeter / members;
  for (BoundaryInterval& interval : this->Intervals)
  {
    interval.Share = sum > 0.0 ? interval.Share * perimeter / sum : mean;
    interval.LimitWeight = interval.Share < TinyInterval * mean ? WeightOfLimit * mean * mean : 0.0;
  }
}

void RefinementTerms::freeBoundary(const std::vector<int>& loop)
{
  this->Intervals.clear();
  this->Outline = outlineEdges(loop);
  this->ShapeLimits.setConstant(this->Faces.rows(), std::numeric_limits<double>::infinity());
}

void RefinementTerms::freeBoundaryWithoutNeedles(const std::vector<int>& loop)
{
  this->freeBoundary(loop);
  const std::unordered_set<int> members(loop.begin(), loop.end());
  for (Eigen::Index f = 0; f < this->Faces.rows(); ++f)
  {
    const auto row = this->Faces.row(f);
    if (std::count_if(row.begin(), row.end(), [&members](int v) { return members.count(v) > 0; }) >= 2)
    {
      this->ShapeLimits[f] = OutlineShapeLimit;
    }
  }
}

} // namespace flattening
