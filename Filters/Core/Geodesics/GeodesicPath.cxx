// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/GeodesicPath.h"

#include "Base/Errors.h"
#include "Geodesics/GeodesicSearch.h"
#include "Mesh/Halfedges.h"

#include <CGAL/boost/graph/properties_Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace flattening
{
namespace
{

using Vertex = SurfaceMesh::Vertex_index;
using Halfedge = SurfaceMesh::Halfedge_index;
using Face = SurfaceMesh::Face_index;

// Half the width of the first strip, in edges. The path does not depend on it unless several are locally
// shortest: narrow strips are searched fast but often, wide ones slowly.
constexpr int FirstRings = 4;

constexpr const char* PathStage = "looking for the geodesic";

int numberIn(const std::vector<Vertex>& sorted, Vertex v)
{
  return static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin());
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
  TriangleMesh mesh(std::vector<Vertex>& original) const
  {
    original = this->Inner;
    original.insert(original.end(), this->Rim.begin(), this->Rim.end());
    std::sort(original.begin(), original.end());
    const std::vector<Face> faces = this->faces();
    TriangleMesh part;
    part.Vertices.resize(static_cast<Eigen::Index>(original.size()), 3);
    for (std::size_t v = 0; v < original.size(); ++v)
    {
      const Kernel::Point_3& point = this->Mesh.point(original[v]);
      part.Vertices.row(static_cast<Eigen::Index>(v)) << point.x(), point.y(), point.z();
    }
    part.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const Halfedge h = this->Mesh.halfedge(faces[f]);
      part.Faces.row(static_cast<Eigen::Index>(f)) << numberIn(original, this->Mesh.source(h)),
        numberIn(original, this->Mesh.target(h)),
        numberIn(original, this->Mesh.target(this->Mesh.next(h)));
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

// A path in a strip of the surface.
struct StripPath
{
  GeodesicPath Path;       // over the surface; without points if the strip has none
  bool IsHeldBack = false; // whether it touches the border of the strip inside the surface
};

bool isAtBorder(const UnfoldableFaces& faces, int place)
{
  const auto begin = faces.Corners.begin();
  return std::any_of(begin + faces.CornerStarts[place],
    begin + faces.CornerStarts[place + 1],
    [&faces](int h) { return faces.Opposite[h] < 0 || faces.Opposite[previousHalfedge(h)] < 0; });
}

StripPath pathInStrip(const SurfaceMesh& mesh,
  const Strip& strip,
  Vertex from,
  Vertex to,
  const ProgressCallback& progress)
{
  std::vector<Vertex> original;
  const UnfoldableFaces faces(strip.mesh(original), Seams::Open);
  GeodesicSearch search(faces, Paths::Kept);
  StripPath found;
  found.Path.Length = search.to({ numberIn(original, from) },
    numberIn(original, to),
    [&progress] { report(progress, 0.5, PathStage); })[0];
  if (!std::isfinite(found.Path.Length))
  {
    return found;
  }
  // Every place is a vertex, because the seams are open.
  for (const PathCrossing& crossing : search.pathFrom(numberIn(original, from)))
  {
    if (crossing.Place >= 0)
    {
      const Vertex v = original[crossing.Place];
      found.IsHeldBack |= isAtBorder(faces, crossing.Place) && !mesh.is_border(v);
      found.Path.Points.push_back({ v, SurfaceMesh::null_halfedge(), 0.0 });
    }
    else
    {
      const Halfedge edge = mesh.halfedge(original[faces.Origin[crossing.Halfedge]],
        original[faces.Origin[nextHalfedge(crossing.Halfedge)]]);
      found.Path.Points.push_back({ SurfaceMesh::null_vertex(), edge, crossing.Fraction });
    }
  }
  return found;
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
  const ProgressCallback& progress,
  const std::vector<Vertex>& near)
{
  report(progress, 0.0, PathStage);
  if (from == to)
  {
    return { { { from, SurfaceMesh::null_halfedge(), 0.0 } }, 0.0 };
  }
  std::vector<Vertex> middle = near.empty() ? shortestEdgePath(mesh, from, to) : near;
  // Strips grow by half, so that they are the whole surface after a number of searches that grows with
  // the logarithm of its size.
  for (int rings = FirstRings;; rings += rings / 2)
  {
    report(progress, 0.5, PathStage);
    Strip strip(mesh, middle);
    const bool isPart = strip.widen(rings);
    StripPath found = pathInStrip(mesh, strip, from, to, progress);
    const bool isWhole = found.Path.Points.size() > 1 && isPathOverFaces(mesh, found.Path.Points);
    if (isWhole && !found.IsHeldBack)
    {
      return std::move(found.Path);
    }
    if (!isPart)
    {
      throw TopologyError("the geodesic between two points of the surface could not be found: repair "
                          "or remesh the surface");
    }
    // If the border of the strip holds the path back, a strip around that path lets the next path come
    // closer to the geodesic.
    middle = isWhole ? std::vector<Vertex>() : middle;
    const std::vector<Vertex> along = verticesAlong(mesh, found.Path.Points);
    middle.insert(middle.end(), along.begin(), along.end());
  }
}

std::vector<Vertex> verticesAlong(const SurfaceMesh& mesh, const std::vector<PathPoint>& path)
{
  std::vector<Vertex> vertices;
  for (const PathPoint& point : path)
  {
    const std::vector<Vertex> corners = cornersOf(mesh, point);
    vertices.insert(vertices.end(), corners.begin(), corners.end());
  }
  return vertices;
}

} // namespace flattening
