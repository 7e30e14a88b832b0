// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/GeodesicPath.h"

#include "Base/Errors.h"
#include "Base/InterruptibleCall.h"

#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/properties_Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

using Vertex = SurfaceMesh::Vertex_index;
using Halfedge = SurfaceMesh::Halfedge_index;
using Face = SurfaceMesh::Face_index;
using ShortestPath =
  CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, SurfaceMesh>>;

// Half the width of the first strip, in edges. The path does not depend on it unless several are locally
// shortest: narrow strips are searched fast but often, wide ones slowly.
constexpr int FirstRings = 4;

constexpr const char* PathStage = "looking for the geodesic";

Vertex numberIn(const std::vector<Vertex>& sorted, Vertex v)
{
  return Vertex(static_cast<SurfaceMesh::size_type>(
    std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin()));
}

struct Arrived
{
};

struct StopAt : boost::default_dijkstra_visitor
{
  Vertex Goal;

  explicit StopAt(Vertex goal)
    : Goal(goal)
  {
  }
  void examine_vertex(Vertex v, const SurfaceMesh&) const
  {
    if (v == this->Goal)
    {
      throw Arrived(); // Boost's way to leave a search early
    }
  }
};

std::vector<Vertex> shortestEdgePath(const SurfaceMesh& mesh, Vertex from, Vertex to)
{
  std::vector<Vertex> parent(mesh.num_vertices());
  const auto index = get(boost::vertex_index, mesh);
  try
  {
    boost::dijkstra_shortest_paths(mesh,
      from,
      boost::predecessor_map(boost::make_iterator_property_map(parent.begin(), index))
        .weight_map(get(boost::edge_weight, mesh))
        .visitor(StopAt(to)));
  }
  catch (const Arrived&)
  {
    std::vector<Vertex> path{ to };
    while (path.back() != from)
    {
      path.push_back(parent[path.back()]);
    }
    return path;
  }
  throw TopologyError("no path over the surface joins two points of it: they lie on parts that are not "
                      "connected");
}

// The faces around all vertices within a number of edges of a path.
class Strip
{
public:
  Strip(const SurfaceMesh& mesh, std::vector<Vertex> path)
    : Mesh(mesh)
    , Rim(std::move(path))
    , Taken(mesh.num_vertices(), 0)
  {
    std::sort(this->Rim.begin(), this->Rim.end());
    this->Rim.erase(std::unique(this->Rim.begin(), this->Rim.end()), this->Rim.end());
    for (const Vertex v : this->Rim)
    {
      this->Taken[v] = 1;
    }
  }

  // Adds rings of faces. Returns whether the surface has more of them.
  bool widen(int rings)
  {
    for (int ring = 0; ring < rings; ++ring)
    {
      std::vector<Vertex> next;
      for (const Vertex v : this->Rim)
      {
        for (const Vertex w : this->Mesh.vertices_around_target(this->Mesh.halfedge(v)))
        {
          if (!this->Taken[w])
          {
            this->Taken[w] = 1;
            next.push_back(w);
          }
        }
      }
      this->Inner.insert(this->Inner.end(), this->Rim.begin(), this->Rim.end());
      this->Rim = std::move(next);
    }
    return !this->Rim.empty();
  }

  // The strip as a mesh of its own. Sets the original of each of its vertices.
  SurfaceMesh mesh(std::vector<Vertex>& original) const
  {
    original = this->Inner;
    original.insert(original.end(), this->Rim.begin(), this->Rim.end());
    std::sort(original.begin(), original.end());
    SurfaceMesh part;
    for (const Vertex v : original)
    {
      part.add_vertex(this->Mesh.point(v));
    }
    for (const Face face : this->faces())
    {
      const Halfedge h = this->Mesh.halfedge(face);
      part.add_face(numberIn(original, this->Mesh.source(h)),
        numberIn(original, this->Mesh.target(h)),
        numberIn(original, this->Mesh.target(this->Mesh.next(h))));
    }
    return part;
  }

private:
  std::vector<Face> faces() const
  {
    std::vector<Face> faces;
    for (const Vertex v : this->Inner)
    {
      for (const Face face : this->Mesh.faces_around_target(this->Mesh.halfedge(v)))
      {
        if (face != SurfaceMesh::null_face())
        {
          faces.push_back(face);
        }
      }
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  const SurfaceMesh& Mesh;
  std::vector<Vertex> Inner; // vertices whose faces all belong to the strip
  std::vector<Vertex> Rim;   // the other vertices
  std::vector<char> Taken;
};

struct PathCollector
{
  std::vector<PathPoint>& Points;

  void operator()(Vertex v) { this->Points.push_back({ v, SurfaceMesh::null_halfedge(), 0.0 }); }
  void operator()(Halfedge edge, double fraction)
  {
    this->Points.push_back({ SurfaceMesh::null_vertex(), edge, fraction });
  }
  // Only for paths that end inside a face.
  void operator()(Face, const ShortestPath::Barycentric_coordinates&) {}
};

// The search for the geodesic in a strip. It owns everything that it uses, because an abort may leave it
// behind.
struct StripGeodesic
{
  SurfaceMesh Strip;
  Vertex From;
  Vertex To;
  GeodesicPath Path;

  void find()
  {
    ShortestPath geodesics(this->Strip);
    geodesics.add_source_point(this->To);
    PathCollector collector{ this->Path.Points };
    this->Path.Length = geodesics.shortest_path_sequence_to_source_points(this->From, collector).first;
  }
};

std::vector<Vertex> cornersOf(const SurfaceMesh& mesh, const PathPoint& point)
{
  return point.isVertex() ? std::vector<Vertex>{ point.Vertex }
                          : std::vector<Vertex>{ mesh.source(point.Edge), mesh.target(point.Edge) };
}

// Whether two different points of a path lie on one face.
bool shareFace(const SurfaceMesh& mesh, const PathPoint& a, const PathPoint& b)
{
  const std::vector<Vertex> ends = cornersOf(mesh, a);
  std::vector<Vertex> both = cornersOf(mesh, b);
  both.insert(both.end(), ends.begin(), ends.end());
  std::sort(both.begin(), both.end());
  both.erase(std::unique(both.begin(), both.end()), both.end());
  const std::size_t differing = both.size() - ends.size();
  if (a.isVertex() == b.isVertex() && differing == 0)
  {
    return false; // the same vertex or edge
  }
  if (both.size() == 2)
  {
    return mesh.halfedge(both[0], both[1]).is_valid();
  }
  return both.size() == 3 && mesh.halfedge(both[0], both[1]).is_valid() &&
         mesh.halfedge(both[1], both[2]).is_valid() && mesh.halfedge(both[2], both[0]).is_valid();
}

// Whether consecutive points lie on one face and no vertex or edge comes twice. Rounding breaks this
// where triangles are longer than wide by more than the digits of a double.
bool isPathOverFaces(const SurfaceMesh& mesh, const std::vector<PathPoint>& points)
{
  std::vector<std::vector<Vertex>> places;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (i > 0 && !shareFace(mesh, points[i - 1], points[i]))
    {
      return false;
    }
    places.push_back(cornersOf(mesh, points[i]));
    std::sort(places.back().begin(), places.back().end());
  }
  std::sort(places.begin(), places.end());
  return std::adjacent_find(places.begin(), places.end()) == places.end();
}

// Whether the point lies on the border of the mesh.
bool isAtBorder(const SurfaceMesh& mesh, const PathPoint& point)
{
  return point.isVertex() ? mesh.is_border(point.Vertex) : mesh.is_border(mesh.edge(point.Edge));
}

} // namespace

Eigen::Vector3d positionOf(const SurfaceMesh& mesh, const PathPoint& point)
{
  const auto at = [&mesh](SurfaceMesh::Vertex_index v)
  {
    const Kernel::Point_3& p = mesh.point(v);
    return Eigen::Vector3d(p.x(), p.y(), p.z());
  };
  return point.isVertex() ? at(point.Vertex)
                          : (1.0 - point.Fraction) * at(mesh.source(point.Edge)) +
                              point.Fraction * at(mesh.target(point.Edge));
}

GeodesicPath geodesicPath(const SurfaceMesh& mesh,
  Vertex from,
  Vertex to,
  const ProgressCallback& progress)
{
  report(progress, 0.0, PathStage);
  if (from == to)
  {
    return { { { from, SurfaceMesh::null_halfedge(), 0.0 } }, 0.0 };
  }
  std::vector<Vertex> middle = shortestEdgePath(mesh, from, to);
  // Strips grow by half, so that they are the whole surface after a number of searches that grows with
  // the logarithm of its size.
  for (int rings = FirstRings;; rings += rings / 2)
  {
    report(progress, 0.5, PathStage);
    Strip strip(mesh, middle);
    const bool isPart = strip.widen(rings);
    std::vector<Vertex> original;
    const auto geodesic = std::make_shared<StripGeodesic>();
    geodesic->Strip = strip.mesh(original);
    geodesic->From = numberIn(original, from);
    geodesic->To = numberIn(original, to);
    callInterruptibly([geodesic]() { geodesic->find(); }, progress, 0.5, PathStage);
    const SurfaceMesh& part = geodesic->Strip;
    GeodesicPath path = std::move(geodesic->Path);
    const bool isWhole = path.Points.size() > 1 && isPathOverFaces(part, path.Points);

    // If the border of the strip holds the path back, a strip around that path lets the next path come
    // closer to the geodesic.
    bool touches = false;
    middle = isWhole ? std::vector<Vertex>() : middle;
    for (PathPoint& point : path.Points)
    {
      const bool atBorder = isAtBorder(part, point);
      if (point.isVertex())
      {
        point.Vertex = original[point.Vertex];
        middle.push_back(point.Vertex);
      }
      else
      {
        point.Edge = mesh.halfedge(original[part.source(point.Edge)], original[part.target(point.Edge)]);
        middle.push_back(mesh.source(point.Edge));
        middle.push_back(mesh.target(point.Edge));
      }
      touches |= atBorder && !isAtBorder(mesh, point);
    }
    if (isWhole && !touches)
    {
      return path;
    }
    if (!isPart)
    {
      throw TopologyError("the geodesic between two points of the surface could not be found: repair "
                          "or remesh the surface");
    }
  }
}

} // namespace flattening
