// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/DomainTarget.h"

#include "Base/Errors.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

// How far a boundary vertex of the input may lie from the boundary of a domain of area pi. A guard: far
// above the rounding of coordinates, far below the edges of the boundary.
constexpr double BoundaryTolerance = 1e-6;
// The names of a domain and its boundary in messages.
struct DomainName
{
  std::string Domain;
  std::string Boundary;
};

void requirePositions(const Points2& positions,
  const std::vector<int>& loop,
  const ConvexDomain& domain,
  const DomainName& name)
{
  const std::string remedy =
    ": the input must be a map to the " + name.Domain + ", run Conformal Disk first";
  for (const int v : loop)
  {
    const Eigen::Vector2d position = positions.row(v);
    if (!((domain.at(domain.parameterOf(position)) - position).norm() <= BoundaryTolerance))
    {
      throw InvalidInput(
        "boundary vertex " + std::to_string(v) + " does not lie on the " + name.Boundary + remedy);
    }
  }
  const Eigen::Vector2d centroid = domain.centroid();
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    const Eigen::Vector2d position = positions.row(v);
    if (!domain.contains(centroid + (1.0 - BoundaryTolerance) * (position - centroid)))
    {
      throw InvalidInput("vertex " + std::to_string(v) + " lies outside of the " + name.Domain + remedy);
    }
  }
}

// Fixes the boundary vertices that lie in the corners of a rectangle.
BoundaryLoop fixedInCorners(const Points2& conformal,
  const std::vector<int>& loop,
  const ConvexPolygon& rectangle,
  const Points2& corners)
{
  std::vector<std::pair<int, double>> fixed; // index into the loop, boundary parameter
  for (Eigen::Index c = 0; c < corners.rows(); ++c)
  {
    const auto distance = [&](int v) { return (conformal.row(v) - corners.row(c)).norm(); };
    const auto nearest = std::min_element(
      loop.begin(), loop.end(), [&](int a, int b) { return distance(a) < distance(b); });
    if (!(distance(*nearest) <= BoundaryTolerance))
    {
      throw InvalidInput("no boundary vertex lies in corner " + std::to_string(c) +
                         " of the rectangle: run Conformal Disk with Domain set to Rectangle first");
    }
    fixed.emplace_back(
      static_cast<int>(nearest - loop.begin()), rectangle.parameterOf(corners.row(c).transpose()));
  }
  // In the order of the loop, the parameters increasing over less than one turn.
  std::sort(fixed.begin(), fixed.end());
  BoundaryLoop boundary{ loop, {}, {} };
  for (const auto& [member, parameter] : fixed)
  {
    boundary.Corners.push_back(member);
    boundary.CornerParameters.push_back(
      parameter < fixed.front().second ? parameter + rectangle.perimeter() : parameter);
  }
  if (!std::is_sorted(boundary.CornerParameters.begin(), boundary.CornerParameters.end()))
  {
    throw InvalidInput("the corners of the rectangle are not in the order of the boundary: the map is "
                       "mirrored, run Conformal Disk first");
  }
  return boundary;
}

} // namespace

DomainTarget diskTarget(const TriangleMesh& mesh, const Points2& conformal)
{
  DomainTarget target{ std::make_shared<UnitDisk>(), { requireDisk(mesh), {}, {} } };
  requirePositions(
    conformal, target.Boundary.Vertices, *target.Domain, { "disk", "circle around the origin" });
  return target;
}

DomainTarget rectangleTarget(const TriangleMesh& mesh, const Points2& conformal, double width)
{
  const std::vector<int> loop = requireDisk(mesh);
  if (!(width > 0.0) || !std::isfinite(width))
  {
    throw InvalidInput("a rectangle of width " + formatted(width) + ": it must be positive");
  }
  const double x = 0.5 * width;
  const double y = 0.5 * EIGEN_PI / width;
  Points2 corners(4, 2);
  corners << -x, -y, x, -y, x, y, -x, y;
  const auto rectangle = std::make_shared<ConvexPolygon>(corners);
  DomainTarget target{ rectangle, fixedInCorners(conformal, loop, *rectangle, corners) };
  requirePositions(conformal, loop, *rectangle, { "rectangle", "sides of the rectangle" });
  return target;
}

DomainTarget polygonTarget(const TriangleMesh& mesh,
  const Points2& conformal,
  const ConvexDomain& source,
  const PolygonTarget& polygon)
{
  BoundaryLoop boundary{ requireDisk(mesh), {}, {} };
  const auto domain = std::make_shared<ConvexPolygon>(polygon.Corners);
  requirePositions(
    conformal, boundary.Vertices, source, { "disk or rectangle", "boundary of the domain" });
  if (polygon.FixCorners)
  {
    boundary.CornerParameters = domain->cornerParameters();
  }
  return { domain, boundary };
}

Points2 stretchedAlongRays(const Points2& positions, const ConvexDomain& from, const ConvexDomain& to)
{
  Points2 stretched(positions.rows(), 2);
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
  {
    const Eigen::Vector2d position = positions.row(v);
    const double share = position.norm() / from.at(from.parameterOf(position)).norm();
    stretched.row(v) = std::min(share, 1.0) * to.at(to.parameterOf(position));
  }
  return stretched;
}

} // namespace flattening
