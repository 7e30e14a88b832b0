// SPDX-License-Identifier: GPL-3.0-or-later
#include "EdgeDistance.h"

#include <CGAL/boost/graph/properties_Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <functional>

namespace flattening
{

using Vertex = SurfaceMesh::Vertex_index;
using Edge = SurfaceMesh::Edge_index;

Eigen::VectorXd distancesAlongEdges(const SurfaceMesh& mesh,
  const std::vector<Vertex>& sources,
  const std::vector<char>& blocked)
{
  const auto isBlocked = [&blocked](Vertex v) { return !blocked.empty() && blocked[v]; };
  const auto length = [&](Edge edge)
  {
    return isBlocked(mesh.vertex(edge, 0)) || isBlocked(mesh.vertex(edge, 1))
             ? HUGE_VAL
             : get(get(boost::edge_weight, mesh), edge);
  };
  Eigen::VectorXd result(mesh.number_of_vertices());
  const auto index = get(boost::vertex_index, mesh);
  boost::dijkstra_shortest_paths(mesh,
    sources.begin(),
    sources.end(),
    boost::dummy_property_map(),
    boost::make_iterator_property_map(result.data(), index),
    boost::make_function_property_map<Edge>(length),
    index,
    std::less<double>(),
    std::plus<double>(),
    HUGE_VAL,
    0.0,
    boost::default_dijkstra_visitor());
  return result;
}

Eigen::VectorXd distancesFromFlagged(const SurfaceMesh& mesh, const std::vector<char>& flags)
{
  std::vector<Vertex> sources;
  for (std::size_t v = 0; v < flags.size(); ++v)
  {
    if (flags[v])
    {
      sources.emplace_back(static_cast<SurfaceMesh::size_type>(v));
    }
  }
  return sources.empty() ? Eigen::VectorXd::Constant(mesh.number_of_vertices(), HUGE_VAL).eval()
                         : distancesAlongEdges(mesh, sources);
}

int indexOfLargest(const Eigen::VectorXd& values)
{
  Eigen::Index largest = 0;
  values.cast<float>().maxCoeff(&largest);
  return static_cast<int>(largest);
}

} // namespace flattening
