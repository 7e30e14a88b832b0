// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/CutGraph.h"

#include "Base/Errors.h"
#include "Mesh/DisjointSets.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshTopology.h"

#include <CGAL/boost/graph/properties_Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>

namespace flattening
{
namespace
{

using Vertex = SurfaceMesh::Vertex_index;

MeshEdge ordered(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

std::vector<MeshEdge> edgesOf(const std::vector<std::vector<int>>& loops)
{
  std::vector<MeshEdge> edges;
  for (const std::vector<int>& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      edges.push_back(ordered(loop[i], loop[(i + 1) % loop.size()]));
    }
  }
  return edges;
}

// Checks that the surface is planar once it is cut along the loops, and returns its topology.
MeshTopology requirePlanar(const TriangleMesh& opened)
{
  MeshTopology topology = analyseTopology(opened.Faces, opened.vertexCount());
  if (topology.Components != 1)
  {
    throw TopologyError("cut along the loops of its handles, the surface falls into " +
                        std::to_string(topology.Components) +
                        " parts: pass one component and loops that do not separate it");
  }
  if (topology.Genus != 0)
  {
    throw TopologyError("cut along the loops of its handles, the surface still has genus " +
                        std::to_string(topology.Genus) + ": pass one loop more for each handle");
  }
  if (topology.BoundaryLoops.empty())
  {
    throw TopologyError("a closed surface of genus 0 has no boundaries to join: open it with a hole "
                        "or along a seam through points instead");
  }
  return topology;
}

// The boundary loop nearest to every vertex, and the shortest edge path to it.
class BoundaryRegions
{
public:
  BoundaryRegions(const SurfaceMesh& mesh, const std::vector<std::vector<int>>& boundaryLoops)
    : Distance(mesh.number_of_vertices())
    , Parent(mesh.number_of_vertices())
    , Loop(mesh.number_of_vertices(), -1)
  {
    std::vector<Vertex> sources;
    for (std::size_t loop = 0; loop < boundaryLoops.size(); ++loop)
    {
      for (const int v : boundaryLoops[loop])
      {
        this->Loop[v] = static_cast<int>(loop);
        sources.emplace_back(v);
      }
    }
    const auto index = get(boost::vertex_index, mesh);
    boost::dijkstra_shortest_paths(mesh,
      sources.begin(),
      sources.end(),
      boost::make_iterator_property_map(this->Parent.begin(), index),
      boost::make_iterator_property_map(this->Distance.begin(), index),
      get(boost::edge_weight, mesh),
      index,
      std::less<double>(),
      std::plus<double>(),
      HUGE_VAL,
      0.0,
      boost::default_dijkstra_visitor());
    std::vector<Vertex> path;
    for (const Vertex v : mesh.vertices())
    {
      Vertex known = v;
      for (path.clear(); this->Loop[known] < 0; known = this->Parent[known])
      {
        path.push_back(known);
      }
      for (const Vertex onPath : path)
      {
        this->Loop[onPath] = this->Loop[known];
      }
    }
  }

  double distance(Vertex v) const { return this->Distance[v]; }
  int loop(Vertex v) const { return this->Loop[v]; }
  /// The next vertex on the way to the boundary; the vertex itself on a boundary.
  Vertex parent(Vertex v) const { return this->Parent[v]; }

private:
  std::vector<double> Distance;
  std::vector<Vertex> Parent;
  std::vector<int> Loop;
};

// An edge where two regions meet, and the length of the path between the boundaries through it.
struct Crossing
{
  double Length;
  Vertex From;
  Vertex To;

  bool operator<(const Crossing& other) const
  {
    return std::tie(this->Length, this->From, this->To) < std::tie(other.Length, other.From, other.To);
  }
};

std::vector<Crossing> crossingsByLength(const SurfaceMesh& mesh, const BoundaryRegions& regions)
{
  std::vector<Crossing> crossings;
  const auto length = get(boost::edge_weight, mesh);
  for (const auto edge : mesh.edges())
  {
    const Vertex from = mesh.vertex(edge, 0);
    const Vertex to = mesh.vertex(edge, 1);
    if (regions.loop(from) != regions.loop(to))
    {
      crossings.push_back(
        { regions.distance(from) + get(length, edge) + regions.distance(to), from, to });
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

// The edges of a minimum spanning tree of paths between the boundary loops (Kruskal's algorithm).
std::vector<MeshEdge> joinBoundaries(const TriangleMesh& opened,
  const std::vector<std::vector<int>>& boundaryLoops)
{
  const SurfaceMesh mesh = toSurfaceMesh(opened);
  const BoundaryRegions regions(mesh, boundaryLoops);
  DisjointSets joined(boundaryLoops.size());

  std::vector<MeshEdge> paths;
  for (const Crossing& crossing : crossingsByLength(mesh, regions))
  {
    const int from = joined.find(regions.loop(crossing.From));
    const int to = joined.find(regions.loop(crossing.To));
    if (from == to)
    {
      continue;
    }
    joined.join(from, to);
    paths.push_back(ordered(crossing.From, crossing.To));
    for (Vertex v : { crossing.From, crossing.To })
    {
      for (; regions.parent(v) != v; v = regions.parent(v))
      {
        paths.push_back(ordered(v, regions.parent(v)));
      }
    }
  }
  return paths;
}

} // namespace

std::vector<MeshEdge> shortCutGraph(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  const ProgressCallback& progress)
{
  report(progress, 0.0, "cutting along the handles");
  std::vector<MeshEdge> graph = edgesOf(loops);
  const DerivedMesh opened = cutAlongEdges(mesh, graph).Surface;
  const MeshTopology topology = requirePlanar(opened.Mesh);

  report(progress, 0.4, "joining the cuts");
  for (const MeshEdge& edge : joinBoundaries(opened.Mesh, topology.BoundaryLoops))
  {
    const auto original = [&opened](int v)
    { return static_cast<int>(VertexOrigins::InnerIterator(opened.Vertices, v).col()); };
    graph.push_back(ordered(original(edge[0]), original(edge[1])));
  }
  std::sort(graph.begin(), graph.end());
  graph.erase(std::unique(graph.begin(), graph.end()), graph.end());
  report(progress, 1.0, "joining the cuts");
  return graph;
}

CutSurface cutToDisk(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  const ProgressCallback& progress)
{
  CutSurface cut = cutAlongEdges(mesh, shortCutGraph(mesh, loops, subrange(progress, 0.0, 0.8)));
  report(progress, 0.8, "checking the disk");
  requireDisk(cut.Surface.Mesh);
  return cut;
}

} // namespace flattening
