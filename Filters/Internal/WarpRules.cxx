// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/WarpRules.h"

#include "Core/Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace flattening
{
namespace
{

// The greatest number of parts of a segment: a guard against a length in other units than the data,
// which would fill the memory.
constexpr double MostParts = 1e6;
constexpr long long MostInserted = 20'000'000; // points in all, as many as remeshing makes at most

} // namespace

WarpedInSpace warpInSpace(const Points3& points, const WarpRules& rules)
{
  const WarpedPoints warped = rules.Warp.warp(points.leftCols(2), rules.Progress);
  WarpedInSpace result;
  result.Positions.resize(points.rows(), 3);
  result.Positions.leftCols(2) = warped.Positions;
  result.Positions.col(2) = points.col(2).array() - rules.Warp.planeHeight();
  result.Inside = warped.Inside;
  return result;
}

int segmentParts(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const WarpRules& rules)
{
  const double length = (b - a).head<2>().norm();
  if (!(rules.MaximalSegment > 0.0) || !std::isfinite(length))
  {
    return 1;
  }
  const double parts = std::ceil(length / rules.MaximalSegment);
  if (parts > MostParts)
  {
    std::ostringstream message;
    message
      << "a segment of length " << length << " would be divided into " << parts
      << " parts: raise the maximal segment length, or check that line and mesh are in the same units";
    throw InvalidInput(message.str());
  }
  return std::max(1, static_cast<int>(parts));
}

void requireRoomFor(long long inserted)
{
  if (inserted > MostInserted)
  {
    throw InvalidInput("the lines would get more than " + std::to_string(MostInserted) +
                       " points: raise the maximal segment length, or check that line and mesh are in "
                       "the same units");
  }
}

void requireSomeInside(const WarpedInSpace& warped, const Points3& points)
{
  if (points.rows() > 0 &&
      std::find(warped.Inside.begin(), warped.Inside.end(), 1) == warped.Inside.end())
  {
    std::ostringstream message;
    message
      << "no point of the data lies on the mesh as it was before it was deformed: the data are at x "
      << points.col(0).minCoeff() << " to " << points.col(0).maxCoeff() << ", y "
      << points.col(1).minCoeff() << " to " << points.col(1).maxCoeff()
      << "; move them to where the mesh's SurfacePoints are";
    throw InvalidInput(message.str());
  }
}

} // namespace flattening
