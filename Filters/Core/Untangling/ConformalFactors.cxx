// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/ConformalFactors.h"

namespace flattening
{
namespace
{

// Least root of a sum of squared lengths, in radii of the unit disk or input units: a guard that keeps
// logarithms finite. Doubles tell points of the disk apart to 1e-16.
constexpr double LeastLength = 1e-15;

} // namespace

Eigen::VectorXd logConformalFactors(const TriangleMesh& surface, const Points2& positions)
{
  Eigen::VectorXd flat = Eigen::VectorXd::Zero(surface.vertexCount());
  Eigen::VectorXd curved = Eigen::VectorXd::Zero(surface.vertexCount());
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = surface.Faces(f, k);
      const int b = surface.Faces(f, (k + 1) % 3);
      const double flatLength2 = (positions.row(b) - positions.row(a)).squaredNorm();
      const double length2 = (surface.Vertices.row(b) - surface.Vertices.row(a)).squaredNorm();
      for (const int v : { a, b })
      {
        flat[v] += flatLength2;
        curved[v] += length2;
      }
    }
  }
  const double floor = LeastLength * LeastLength;
  return 0.5 * (flat.array().max(floor).log() - curved.array().max(floor * floor).log());
}

} // namespace flattening
