// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/DijkstraDistance.h"

#include <CGAL/boost/graph/properties_Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <functional>

namespace flattening
{

using Vertex = SurfaceMesh::Vertex_index;

namespace
{

// Sets the distances of the vertices from the nearest source, in the order of their distances. The
// visitor may end the search by an exception.
template <typename Visitor>
void searchAlongEdges(const SurfaceMesh& mesh,
  const std::vector<Vertex>& sources,
  const std::vector<char>& blocked,
  Eigen::VectorXd& distances,
  const Visitor& visitor)
{
  const auto length = [&mesh, &blocked](SurfaceMesh::Edge_index edge)
  {
    const Vertex from = mesh.vertex(edge, 0);
    const Vertex to = mesh.vertex(edge, 1);
    const bool isFree = blocked.empty() || !(blocked[from] || blocked[to]);
    return isFree ? std::sqrt(CGAL::squared_distance(mesh.point(from), mesh.point(to))) : HUGE_VAL;
  };
  distances.resize(mesh.number_of_vertices());
  const auto index = get(boost::vertex_index, mesh);
  boost::dijkstra_shortest_paths(mesh,
    sources.begin(),
    sources.end(),
    boost::dummy_property_map(),
    boost::make_iterator_property_map(distances.data(), index),
    boost::make_function_property_map<SurfaceMesh::Edge_index, double>(length),
    index,
    std::less<double>(),
    std::plus<double>(),
    HUGE_VAL,
    0.0,
    visitor);
}

struct TargetFound
{
  Vertex Target;
};

struct EndAtTarget : boost::default_dijkstra_visitor
{
  const std::function<bool(Vertex)>* IsTarget = nullptr;
  const Eigen::VectorXd* Distances = nullptr;

  template <typename Graph>
  void examine_vertex(Vertex v, const Graph&) const
  {
    // Boost also visits the vertices to which no path leads, after all others.
    if (std::isfinite((*this->Distances)[v]) && (*this->IsTarget)(v))
    {
      throw TargetFound{ v };
    }
  }
};

} // namespace

Eigen::VectorXd distancesAlongEdges(const SurfaceMesh& mesh,
  const std::vector<Vertex>& sources,
  const std::vector<char>& blocked)
{
  Eigen::VectorXd distances;
  searchAlongEdges(mesh, sources, blocked, distances, boost::default_dijkstra_visitor());
  return distances;
}

NearestTarget nearestTarget(const SurfaceMesh& mesh,
  Vertex source,
  const std::function<bool(Vertex)>& isTarget,
  const std::vector<char>& blocked)
{
  NearestTarget nearest;
  EndAtTarget visitor;
  visitor.IsTarget = &isTarget;
  visitor.Distances = &nearest.Distances;
  try
  {
    searchAlongEdges(mesh, { source }, blocked, nearest.Distances, visitor);
  }
  catch (const TargetFound& found)
  {
    nearest.Vertex = found.Target;
  }
  return nearest;
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

std::vector<int> shortestPath(const SurfaceMesh& mesh, const Eigen::VectorXd& distances, Vertex end)
{
  std::vector<int> path{ static_cast<int>(end.idx()) };
  // Distances fall from vertex to vertex, so that no vertex comes twice.
  for (Vertex v = end; distances[v] > 0.0;)
  {
    Vertex next = v;
    double least = HUGE_VAL;
    for (const Vertex other : mesh.vertices_around_target(mesh.halfedge(v)))
    {
      const double length =
        distances[other] + std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(other)));
      if (distances[other] < distances[v] && length < least)
      {
        least = length;
        next = other;
      }
    }
    if (next == v) // only where rounding makes the step from a source vanish
    {
      break;
    }
    path.push_back(static_cast<int>(next.idx()));
    v = next;
  }
  return path;
}

int indexOfLargest(const Eigen::VectorXd& values)
{
  Eigen::Index largest = 0;
  values.cast<float>().maxCoeff(&largest);
  return static_cast<int>(largest);
}

} // namespace flattening
