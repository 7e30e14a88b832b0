// SPDX-License-Identifier: GPL-3.0-or-later
#include "HolePlacement.h"

#include "EditableSurface.h"

#include <CGAL/boost/graph/properties_Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <Eigen/Core>

namespace flattening
{
namespace
{

constexpr int Samples = 8;

Eigen::VectorXd distancesAlongEdges(const SurfaceMesh& mesh, int source)
{
  const auto distance = mesh.number_of_vertices();
  Eigen::VectorXd result(distance);
  boost::dijkstra_shortest_paths(mesh,
    SurfaceMesh::Vertex_index(source),
    boost::distance_map(boost::make_iterator_property_map(result.data(), get(boost::vertex_index, mesh)))
      .weight_map(get(boost::edge_weight, mesh)));
  return result;
}

// In single precision, so that candidates equal up to rounding tie and the first one wins.
int indexOfLargest(const Eigen::VectorXd& values)
{
  Eigen::Index largest = 0;
  values.cast<float>().maxCoeff(&largest);
  return static_cast<int>(largest);
}

} // namespace

int geodesicCentre(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  const SurfaceMesh surface = toSurfaceMesh(mesh);
  int sample = indexOfLargest(distancesAlongEdges(surface, 0));
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(mesh.vertexCount(), HUGE_VAL);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.vertexCount());
  for (int i = 0; i < Samples; ++i)
  {
    report(progress, static_cast<double>(i) / Samples, "placing the hole");
    const Eigen::VectorXd distance = distancesAlongEdges(surface, sample);
    sum += distance;
    nearest = nearest.cwiseMin(distance);
    sample = indexOfLargest(nearest);
  }
  return indexOfLargest(-sum);
}

} // namespace flattening
