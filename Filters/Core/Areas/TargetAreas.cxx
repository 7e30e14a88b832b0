// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/TargetAreas.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace flattening
{
namespace
{

// Resolvable areas are at least this share of the circle's segment over the longest side, and at most
// this share of the mean target. Choices: larger ones spoil more areas in the first stage, with smaller
// ones more faces flip at small holes.
constexpr double SegmentShare = 0.3;
constexpr double LargestShare = 0.3;

// The least area of a face, in mean areas, that its target is made of. A guard for faces without area on
// the surface, which would divide by 0.
constexpr double LeastFaceArea = 1e-6;

// The area, in mean areas, that smaller faces count like, and the greatest factor of a face. Choices
// by trial: without the first the refinement of an isosurface takes three times as many rounds and ends
// with four times as many faces off by more than 2 %; with a larger factor angles suffer around slivers.
constexpr double CountedArea = 0.5;
constexpr double GreatestCountFactor = 20.0;

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

// Throws if a weight makes a target vanish beside the domain. Areas and targets are shares of their
// sums.
void requireResolved(const Eigen::VectorXd& areas,
  const Eigen::VectorXd& targets,
  const Eigen::VectorXd& weights)
{
  constexpr double least = std::numeric_limits<double>::epsilon();
  for (Eigen::Index v = 0; v < areas.size(); ++v)
  {
    if (targets[v] < least && areas[v] >= least)
    {
      std::ostringstream message;
      message << "the area weight " << weights[v] << " of vertex " << v << " gives it " << targets[v]
              << " of the domain, below what double precision resolves: weights run from "
              << weights.minCoeff() << " to " << weights.maxCoeff()
              << ", bring the weights nearer together";
      throw InvalidInput(message.str());
    }
  }
}

} // namespace

Eigen::VectorXd targetAreas(const TriangleMesh& mesh, const Eigen::VectorXd& weights)
{
  Eigen::VectorXd areas = vertexAreas(mesh);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (!(areas[v] > 0.0))
    {
      throw InvalidInput("vertex " + std::to_string(v) +
                         " has no area, all of its triangles are degenerate: run Surface To Disk first");
    }
    if (weights.size() > 0 && (!(weights[v] > 0.0) || !std::isfinite(weights[v])))
    {
      throw InvalidInput("the area weight of vertex " + std::to_string(v) + " is " +
                         formatted(weights[v]) + ": weights must be positive, finite numbers");
    }
  }
  if (weights.size() == 0)
  {
    return areas * (EIGEN_PI / areas.sum());
  }
  areas /= areas.sum();
  // The weights' common factor does not count, but it must not overflow.
  const Eigen::VectorXd weighted = areas.cwiseProduct(weights / weights.maxCoeff());
  const Eigen::VectorXd shares = weighted / weighted.sum();
  requireResolved(areas, shares, weights);
  return EIGEN_PI * shares;
}

Eigen::VectorXd faceTargets(const TriangleMesh& mesh, const Eigen::VectorXd& weights)
{
  const Eigen::VectorXd areas = faceAreas(mesh.Vertices, mesh.Faces);
  Eigen::VectorXd targets = areas.cwiseMax(LeastFaceArea * areas.mean());
  if (weights.size() > 0)
  {
    const Eigen::VectorXd relative = weights / weights.maxCoeff(); // which does not overflow
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      targets[f] *= relative(mesh.Faces.row(f)).mean();
    }
  }
  return targets;
}

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

Eigen::VectorXd scaledTargets(const Eigen::VectorXd& targets, double area)
{
  return targets * (area / targets.sum());
}

Eigen::VectorXd areaWeights(const Eigen::VectorXd& areas)
{
  const double counted = CountedArea * areas.mean();
  return (counted / areas.array()).max(1.0).min(GreatestCountFactor);
}

Eigen::VectorXd faceCounts(const TriangleMesh& surface, const Eigen::VectorXd& targets)
{
  return scaledTargets(faceTargets(surface, {}), targets.sum()).cwiseQuotient(targets);
}

} // namespace flattening
