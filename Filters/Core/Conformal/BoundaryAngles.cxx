// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/BoundaryAngles.h"

#include <cmath>
#include <limits>

namespace flattening
{

Eigen::VectorXd loopLengths(const TriangleMesh& mesh, const std::vector<int>& loop, double addedLength)
{
  const std::size_t count = loop.size();
  Eigen::VectorXd lengths(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    const auto edge = mesh.Vertices.row(loop[(k + 1) % count]) - mesh.Vertices.row(loop[k]);
    lengths[k] = edge.stableNorm() + addedLength;
  }
  return lengths;
}

Eigen::VectorXd anglesInProportion(const Eigen::VectorXd& lengths)
{
  const double perUnit = 2.0 * EIGEN_PI / lengths.sum();
  Eigen::VectorXd angles(lengths.size());
  double angle = 0.0;
  for (Eigen::Index k = 0; k < lengths.size(); ++k)
  {
    angles[k] = angle;
    angle += perUnit * lengths[k];
  }
  return angles;
}

ComplexVector halfPlaneBoundary(const Eigen::VectorXd& angles)
{
  ComplexVector points(angles.size());
  for (Eigen::Index k = 0; k < angles.size(); ++k)
  {
    points[k] =
      angles[k] > 0.0 ? -1.0 / std::tan(0.5 * angles[k]) : std::numeric_limits<double>::infinity();
  }
  return points;
}

} // namespace flattening
