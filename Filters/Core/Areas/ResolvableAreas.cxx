// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/ResolvableAreas.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

constexpr double SegmentShare = 0.3;
constexpr double LargestShare = 0.3; // of the mean target

double longestSide(const FaceMatrix& faces, const Points2& positions, Eigen::Index face)
{
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const auto side = positions.row(faces(face, (k + 1) % 3)) - positions.row(faces(face, k));
    longest = std::max(longest, side.norm());
  }
  return longest;
}

double distanceFromCentre(const FaceMatrix& faces, const Points2& positions, Eigen::Index face)
{
  return (positions.row(faces(face, 0)) + positions.row(faces(face, 1)) + positions.row(faces(face, 2)))
    .norm();
}

} // namespace

Eigen::VectorXd resolvableAreas(const FaceMatrix& faces,
  const Points2& conformal,
  const Points2& positions,
  const Eigen::VectorXd& targets)
{
  const double largest = LargestShare * targets.mean();
  Eigen::VectorXd result = targets;
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
  {
    const double before = distanceFromCentre(faces, conformal, f);
    const double after = distanceFromCentre(faces, positions, f);
    double side = longestSide(faces, positions, f);
    if (before > 0.0)
    {
      side = std::min(side, longestSide(faces, conformal, f) * std::max(1.0, after / before));
    }
    const double segment = side * side * side / 12.0;
    result[f] = std::max(result[f], std::min(SegmentShare * segment, largest));
  }
  return result * (targets.sum() / result.sum());
}

} // namespace flattening
