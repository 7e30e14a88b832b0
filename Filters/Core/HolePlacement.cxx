// SPDX-License-Identifier: GPL-3.0-or-later
#include "HolePlacement.h"

#include "EditableSurface.h"

#include <CGAL/boost/graph/properties_Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace flattening
{
namespace
{

constexpr int Samples = 8;

Eigen::VectorXd distancesAlongEdges(const SurfaceMesh& mesh, int source)
{
  Eigen::VectorXd result(mesh.number_of_vertices());
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
  const Eigen::VectorXd area =
    vertexAreas(mesh.Faces, faceAreas(mesh.Vertices, mesh.Faces), mesh.vertexCount());

  // Farthest-point samples; each stands for the area that is nearest to it.
  Eigen::MatrixXd squared(mesh.vertexCount(), Samples);
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(mesh.vertexCount(), HUGE_VAL);
  std::vector<int> nearestSample(mesh.vertexCount(), 0);
  int sample = indexOfLargest(distancesAlongEdges(surface, 0));
  for (int i = 0; i < Samples; ++i)
  {
    report(progress, static_cast<double>(i) / Samples, "placing the hole");
    const Eigen::VectorXd distance = distancesAlongEdges(surface, sample);
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
  return indexOfLargest(-squared * weight);
}

} // namespace flattening
