// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/TargetAreas.h"

#include "Base/Errors.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace flattening
{
namespace
{

// Areas and targets as shares of their sums: weights must not make a target vanish beside the domain.
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
  Eigen::VectorXd areas =
    vertexAreas(mesh.Faces, faceAreas(mesh.Vertices, mesh.Faces), mesh.vertexCount());
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
                         std::to_string(weights[v]) + ": weights must be positive, finite numbers");
    }
  }
  if (weights.size() == 0)
  {
    return areas * (EIGEN_PI / areas.sum());
  }
  areas /= areas.sum();
  // Their common factor must not overflow.
  const Eigen::VectorXd weighted = areas.cwiseProduct(weights / weights.maxCoeff());
  const Eigen::VectorXd shares = weighted / weighted.sum();
  requireResolved(areas, shares, weights);
  return EIGEN_PI * shares;
}

Eigen::VectorXd faceTargets(const TriangleMesh& mesh, const Eigen::VectorXd& weights)
{
  Eigen::VectorXd targets = faceAreas(mesh.Vertices, mesh.Faces);
  if (weights.size() > 0)
  {
    for (int f = 0; f < mesh.faceCount(); ++f)
    {
      targets[f] *=
        (weights[mesh.Faces(f, 0)] + weights[mesh.Faces(f, 1)] + weights[mesh.Faces(f, 2)]) / 3.0;
    }
  }
  return targets;
}

} // namespace flattening
