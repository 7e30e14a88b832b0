// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/DijkstraDistance.h"

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <functional>
#include <utility>

namespace flattening
{

using Vertex = SurfaceMesh::Vertex_index;
using Halfedge = SurfaceMesh::Halfedge_index;

struct DijkstraDistances::Graph
{
  struct Edge
  {
    double Length;
  };
  using Directed = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Edge>;

  template <typename Ends, typename Lengths>
  Graph(const Ends& ends, const Lengths& lengths, std::size_t vertices)
    : Edges(boost::edges_are_unsorted_multi_pass, ends.begin(), ends.end(), lengths.begin(), vertices)
  {
  }

  Directed Edges; // every edge of the surface in both directions
};

DijkstraDistances::DijkstraDistances(const SurfaceMesh& mesh, const std::vector<char>& blocked)
{
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  std::vector<Graph::Edge> lengths;
  ends.reserve(mesh.number_of_halfedges());
  lengths.reserve(mesh.number_of_halfedges());
  for (const Halfedge h : mesh.halfedges())
  {
    const Vertex from = mesh.source(h);
    const Vertex to = mesh.target(h);
    if (blocked.empty() || !(blocked[from] || blocked[to]))
    {
      ends.emplace_back(from, to);
      lengths.push_back({ std::sqrt(CGAL::squared_distance(mesh.point(from), mesh.point(to))) });
    }
  }
  this->Edges = std::make_unique<Graph>(ends, lengths, mesh.number_of_vertices());
}

DijkstraDistances::~DijkstraDistances() = default;

Eigen::VectorXd DijkstraDistances::from(const std::vector<Vertex>& sources) const
{
  const Graph::Directed& graph = this->Edges->Edges;
  const std::vector<std::size_t> starts(sources.begin(), sources.end());
  Eigen::VectorXd result(static_cast<Eigen::Index>(num_vertices(graph)));
  const auto index = get(boost::vertex_index, graph);
  const auto distance = boost::make_iterator_property_map(result.data(), index);
  boost::dijkstra_shortest_paths(graph,
    starts.begin(),
    starts.end(),
    boost::dummy_property_map(),
    distance,
    get(&Graph::Edge::Length, graph),
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
                         : DijkstraDistances(mesh).from(sources);
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
