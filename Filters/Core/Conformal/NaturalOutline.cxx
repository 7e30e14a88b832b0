// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/NaturalOutline.h"

#include "Conformal/BoundaryAngles.h"
#include "Conformal/CotangentWeights.h"
#include "Conformal/CurvatureSystem.h"
#include "Conformal/ProtrusionSpreading.h"
#include "Mesh/ComplexPositions.h"
#include "Mesh/OutlineCrossings.h"
#include "Mesh/PlaneVectors.h"
#include "Untangling/OutlineUntangling.h"
#include "Untangling/TargetTriangles.h"

#include <cmath>
#include <iterator>
#include <numeric>

namespace flattening
{
namespace
{

// The shares of a convex polygon in the outline to try. A choice: outlines of brains and heads that were
// cut along their reliefs mostly cross themselves in one or two places with 0; of five, one needed a
// half and one 0.8. How round the outline is hardly matters for the map that is made from it.
constexpr double Roundnesses[] = { 0.0, 0.25, 0.5, 0.75, 1.0 };
constexpr const char* OutlineStage = "Natural outline";

// The closed polygon with these exterior angles and nearly these lengths of the sides that follow the
// corners.
Points2 closedPolygon(const Eigen::VectorXd& angles, const Eigen::VectorXd& lengths)
{
  const Eigen::Index n = lengths.size();
  Points2 directions(n, 2);
  double direction = 0.0;
  for (Eigen::Index k = 0; k < n; ++k)
  {
    direction += angles[k];
    directions.row(k) << std::cos(direction), std::sin(direction);
  }
  const Eigen::Matrix2d moments = directions.transpose() * lengths.asDiagonal() * directions;
  const Eigen::Vector2d correction = moments.inverse() * (directions.transpose() * lengths);
  const Eigen::VectorXd closed = lengths - lengths.asDiagonal() * (directions * correction);
  Points2 polygon = Points2::Zero(n, 2);
  for (Eigen::Index k = 0; k + 1 < n; ++k)
  {
    polygon.row(k + 1) = polygon.row(k) + closed[k] * directions.row(k);
  }
  return polygon;
}

// The angle of a flat surface minus that of this one at every vertex.
Eigen::VectorXd angleDefects(const IntrinsicTriangulation& surface)
{
  const Eigen::VectorXd flat = flatAngleSums(surface);
  CurvatureSystem system(surface, flat, std::vector<char>(surface.vertexCount(), 0));
  system.evaluate(IntrinsicTriangulation::Factors::Zero(surface.vertexCount()));
  return system.gradient();
}

} // namespace

NaturalOutlineMap::NaturalOutlineMap(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const ProgressCallback& progress)
  : Loop(loop)
  , Surface(mesh)
  , Area(faceAreas(mesh.Vertices, mesh.Faces).sum())
{
  this->Surface.flipToDelaunay(subrange(progress, 0.0, 0.2));
  this->Lengths = loopLengths(mesh, loop, this->Surface.addedLength());
  std::vector<char> onBoundary(mesh.vertexCount(), 0);
  for (const int v : loop)
  {
    onBoundary[v] = 1;
  }
  this->Means.emplace(
    cotangentWeights(this->Surface, IntrinsicTriangulation::Factors::Zero(mesh.vertexCount())),
    WeightSymmetry::Symmetric,
    onBoundary,
    subrange(progress, 0.2, 0.7));
  const Eigen::VectorXd defects = angleDefects(this->Surface);
  this->Angles = this->Means->passedToFixed(defects, atFraction(progress, 0.7, OutlineStage))(loop);
  // The cotangent Laplacian has half of these weights.
  const Eigen::VectorXd factors =
    -2.0 * this->Means->potential(defects, atFraction(progress, 0.8, OutlineStage));
  this->LogFactors = factors.cast<long double>();
}

Points2 NaturalOutlineMap::outline(double roundness) const
{
  const Eigen::Index count = this->Lengths.size();
  Eigen::VectorXd angles = (1.0 - roundness) * this->Angles;
  const double turn = roundness * EIGEN_PI / this->Lengths.sum(); // per length, at either end
  for (Eigen::Index k = 0; k < count; ++k)
  {
    angles[k] += turn * this->Lengths[k];
    angles[(k + 1) % count] += turn * this->Lengths[k];
  }
  return closedPolygon(angles, this->Lengths);
}

Points2 NaturalOutlineMap::extended(const Points2& outline, const ProgressCallback& progress)
{
  Points2 positions = Points2::Zero(this->LogFactors.size(), 2);
  for (std::size_t k = 0; k < this->Loop.size(); ++k)
  {
    positions.row(this->Loop[k]) = outline.row(k);
  }
  ComplexVector map = complexOf(positions);
  this->Means->extend(map, progress);
  double twiceCovered = 0.0; // by the polygon of the outline
  for (Eigen::Index k = 0; k < outline.rows(); ++k)
  {
    const Eigen::Vector2d next = outline.row((k + 1) % outline.rows());
    twiceCovered += cross(Eigen::Vector2d(outline.row(k)), next);
  }
  if (twiceCovered > 0.0)
  {
    spreadProtrusions(this->Surface,
      IntrinsicTriangulation::Factors::Zero(this->LogFactors.size()),
      this->LogFactors,
      0.5 * std::log(0.5 * twiceCovered / this->Area),
      map,
      static_cast<int>(this->LogFactors.size()));
  }
  return pointsOf(map);
}

MapsNearNaturalOutline::MapsNearNaturalOutline(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const ProgressCallback& progress)
  : Mesh(mesh)
  , Loop(loop)
  , Natural(mesh, loop, progress)
{
}

std::optional<Points2> MapsNearNaturalOutline::next(const ProgressCallback& progress)
{
  std::vector<int> polygon(this->Loop.size());
  std::iota(polygon.begin(), polygon.end(), 0);
  const std::size_t first = this->Tried;
  while (this->Tried < std::size(Roundnesses))
  {
    const double parts = static_cast<double>(std::size(Roundnesses) - first);
    const double begin = static_cast<double>(this->Tried - first) / parts;
    const ProgressCallback part = subrange(progress, begin, begin + 1.0 / parts);
    const Points2 outline = this->Natural.outline(Roundnesses[this->Tried++]);
    if (isSimpleOutline(outline, polygon))
    {
      Points2 positions = this->Natural.extended(outline, subrange(part, 0.0, 0.5));
      if (makeOneToOne(this->Mesh.Faces,
            this->Loop,
            similarTriangles(this->Mesh, positions),
            positions,
            {},
            subrange(part, 0.5, 1.0)))
      {
        return positions;
      }
    }
  }
  return std::nullopt;
}

} // namespace flattening
