// SPDX-License-Identifier: GPL-3.0-or-later
#include "HolePlacement.h"

#include "EditableSurface.h"
#include "Errors.h"

#include <CGAL/boost/graph/properties_Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace flattening
{
namespace
{

constexpr int Samples = 8;

using Vertex = SurfaceMesh::Vertex_index;

// Of every vertex from the nearest source.
Eigen::VectorXd distancesAlongEdges(const SurfaceMesh& mesh, const std::vector<Vertex>& sources)
{
  Eigen::VectorXd result(mesh.number_of_vertices());
  const auto index = get(boost::vertex_index, mesh);
  boost::dijkstra_shortest_paths(mesh,
    sources.begin(),
    sources.end(),
    boost::dummy_property_map(),
    boost::make_iterator_property_map(result.data(), index),
    get(boost::edge_weight, mesh),
    index,
    std::less<double>(),
    std::plus<double>(),
    HUGE_VAL,
    0.0,
    boost::default_dijkstra_visitor());
  return result;
}

// Distances from the flagged vertices; infinite if none is flagged.
Eigen::VectorXd distancesFrom(const SurfaceMesh& mesh, const std::vector<char>& avoided)
{
  std::vector<Vertex> sources;
  for (std::size_t v = 0; v < avoided.size(); ++v)
  {
    if (avoided[v])
    {
      sources.emplace_back(static_cast<SurfaceMesh::size_type>(v));
    }
  }
  if (!sources.empty() && sources.size() == mesh.number_of_vertices())
  {
    throw InvalidInput("the region that the hole must avoid covers all of the surface: mark a part of "
                       "it, or pick the hole's point");
  }
  return sources.empty() ? Eigen::VectorXd::Constant(mesh.number_of_vertices(), HUGE_VAL).eval()
                         : distancesAlongEdges(mesh, sources);
}

// In single precision, so that candidates equal up to rounding tie and the first one wins.
int indexOfLargest(const Eigen::VectorXd& values)
{
  Eigen::Index largest = 0;
  values.cast<float>().maxCoeff(&largest);
  return static_cast<int>(largest);
}

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
  const SurfaceMesh surface = toSurfaceMesh(mesh);
  const Eigen::VectorXd distanceFromAvoided = distancesFrom(surface, avoided);
  if (!(distanceFromAvoided.maxCoeff() > clearance))
  {
    return indexOfLargest(distanceFromAvoided);
  }
  const Eigen::VectorXd area =
    vertexAreas(mesh.Faces, faceAreas(mesh.Vertices, mesh.Faces), mesh.vertexCount());

  // Farthest-point samples; each stands for the area that is nearest to it.
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
  const Eigen::VectorXd closeness = -squared * weight;
  return indexOfLargest((distanceFromAvoided.array() > clearance).select(closeness, -HUGE_VAL));
}

} // namespace flattening
