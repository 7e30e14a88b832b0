// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/HolePlacement.h"

#include "Base/Errors.h"
#include "Geodesics/DijkstraDistance.h"
#include "Mesh/EditableSurface.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace flattening
{
namespace
{

// The number of points from which distances are averaged. A convention: each costs a search over the
// whole surface, and eight tell the middle of a surface from its protrusions.
constexpr int Samples = 8;

using Vertex = SurfaceMesh::Vertex_index;

} // namespace

int geodesicCentre(const TriangleMesh& mesh,
  const std::vector<char>& avoided,
  double clearance,
  const ProgressCallback& progress)
{
  if (!avoided.empty() && avoided.size() != static_cast<std::size_t>(mesh.vertexCount()))
  {
    throw InvalidInput("the region that the hole must avoid has " + std::to_string(avoided.size()) +
                       " flags, but the surface has " + std::to_string(mesh.vertexCount()) +
                       " vertices: pass one flag per vertex");
  }
  if (!avoided.empty() && std::find(avoided.begin(), avoided.end(), 0) == avoided.end())
  {
    throw InvalidInput("the region that the hole must avoid covers all of the surface: mark a part of "
                       "it, or pick the hole's point");
  }
  const SurfaceMesh surface = toSurfaceMesh(mesh);
  const Eigen::VectorXd distanceFromAvoided = distancesFromFlagged(surface, avoided);
  if (!(distanceFromAvoided.maxCoeff() > clearance))
  {
    return indexOfLargest(distanceFromAvoided);
  }
  const Eigen::VectorXd area = vertexAreas(mesh);

  // Each sample is the vertex farthest from those before it, and stands for the area that is nearest to
  // it.
  Eigen::MatrixXd squared(mesh.vertexCount(), Samples);
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(mesh.vertexCount(), HUGE_VAL);
  std::vector<int> nearestSample(mesh.vertexCount(), 0);
  int sample = indexOfLargest(distancesAlongEdges(surface, { Vertex(0) }));
  for (int i = 0; i < Samples; ++i)
  {
    report(progress, static_cast<double>(i) / Samples, "placing the hole");
    const Eigen::VectorXd distance = distancesAlongEdges(surface, { Vertex(sample) });
    squared.col(i) = distance.cwiseAbs2();
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (distance[v] < nearest[v])
      {
        nearest[v] = distance[v];
        nearestSample[v] = i;
      }
    }
    sample = indexOfLargest(nearest);
  }
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(Samples);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    weight[nearestSample[v]] += area[v];
  }
  Eigen::VectorXd closeness = -squared * weight;
  if (const double greatest = closeness.cwiseAbs().maxCoeff(); greatest > 0.0)
  {
    closeness /= greatest; // single precision does not hold the fourth powers of all lengths
  }
  return indexOfLargest((distanceFromAvoided.array() > clearance).select(closeness, -HUGE_VAL));
}

} // namespace flattening
