// SPDX-License-Identifier: GPL-3.0-or-later
#include "Untangling/TargetTriangles.h"

#include "Mesh/PlaneVectors.h"
#include "Mesh/SliverThresholds.h"
#include "Untangling/ConformalFactors.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace flattening
{
namespace
{

// A triangle congruent to the face, its altitude over the longest side raised to the least one.
TargetTriangle openedTriangle(const TriangleMesh& surface, int face)
{
  double squaredSides[3]; // from the first to the second corner, second to third, third to first
  for (int k = 0; k < 3; ++k)
  {
    const int a = surface.Faces(face, k);
    const int b = surface.Faces(face, (k + 1) % 3);
    squaredSides[k] = (surface.Vertices.row(b) - surface.Vertices.row(a)).squaredNorm();
  }
  const int longest = static_cast<int>(std::max_element(squaredSides, squaredSides + 3) - squaredSides);
  const double base2 = squaredSides[longest];
  const double left2 = squaredSides[(longest + 2) % 3];
  const double right2 = squaredSides[(longest + 1) % 3];
  const double base = std::sqrt(base2);
  const double foot = std::clamp(0.5 * (base2 + left2 - right2) / base, 0.0, base);
  const double altitude = std::sqrt(std::max(0.0, left2 - foot * foot));
  Eigen::Vector2d corners[3];
  corners[longest] = Eigen::Vector2d::Zero();
  corners[(longest + 1) % 3] = Eigen::Vector2d(base, 0.0);
  corners[(longest + 2) % 3] = Eigen::Vector2d(foot, std::max(altitude, slivers::TargetAltitude * base));
  return { corners[1] - corners[0], corners[2] - corners[0] };
}

} // namespace

TargetTriangles similarTriangles(const TriangleMesh& surface, const Points2& positions)
{
  const auto scales = std::make_shared<const Eigen::VectorXd>(logConformalFactors(surface, positions));
  return [&surface, scales](int face)
  {
    double logScale = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      logScale += (*scales)[surface.Faces(face, k)] / 3.0;
    }
    const TargetTriangle triangle = openedTriangle(surface, face);
    return TargetTriangle{ std::exp(logScale) * triangle.Second, std::exp(logScale) * triangle.Third };
  };
}

TargetTriangles trianglesOfArea(const TriangleMesh& surface, const Eigen::VectorXd& areas)
{
  const auto kept = std::make_shared<const Eigen::VectorXd>(areas);
  return [&surface, kept](int face)
  {
    const TargetTriangle triangle = openedTriangle(surface, face);
    const double area = 0.5 * cross(triangle.Second, triangle.Third);
    const double scale = std::sqrt((*kept)[face] / area);
    return TargetTriangle{ scale * triangle.Second, scale * triangle.Third };
  };
}

} // namespace flattening
