// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/WarpRules.h"

#include "Core/Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace flattening
{
namespace
{

// Guards against a length in other units than the data's.
constexpr double MostParts = 1e6;

} // namespace

CarriedInSpace carryInSpace(const Points3& points, const WarpRules& rules)
{
  const CarriedPoints carried = rules.Warp.carry(points.leftCols(2), rules.Progress);
  CarriedInSpace result;
  result.Positions.resize(points.rows(), 3);
  result.Positions.leftCols(2) = carried.Positions;
  result.Positions.col(2) = points.col(2).array() - rules.Warp.planeHeight();
  result.Inside = carried.Inside;
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

void requireSomeInside(const CarriedInSpace& carried, const Points3& points)
{
  if (std::find(carried.Inside.begin(), carried.Inside.end(), 1) == carried.Inside.end())
  {
    std::ostringstream message;
    message
      << "nothing of the data lies on the mesh as it was before it was deformed: the data are at x "
      << points.col(0).minCoeff() << " to " << points.col(0).maxCoeff() << ", y "
      << points.col(1).minCoeff() << " to " << points.col(1).maxCoeff()
      << "; move them to where the mesh's SurfacePoints are";
    throw InvalidInput(message.str());
  }
}

} // namespace flattening
