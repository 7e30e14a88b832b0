// SPDX-License-Identifier: GPL-3.0-or-later
#include "GeodesicHole.h"

#include "BoundarySlivers.h"
#include "EditableSurface.h"
#include "GeodesicDistance.h"
#include "HolePlacement.h"
#include "LongestEdgeBisection.h"
#include "MeshTopology.h"
#include "SurfaceProjection.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Vertex = EditableSurface::Vertex;
using Halfedge = EditableSurface::Halfedge;
using Face = EditableSurface::Face;

constexpr double Pi = 3.14159265358979323846;
// Edges that the curve crosses are at most this share of the spacing asked for, so that enough curve
// points are left after the short edges are collapsed.
constexpr double EdgePerSpacing = 0.75;
// The distance is computed on a neighbourhood of this many times the hole's area: its edge is then more
// than twice the radius away, where it has no influence on the curve.
constexpr double NeighbourhoodAreas = 6.0;
// Refined to the curve's resolution: distances within this factor of the radius.
constexpr double RingWidth = 1.25;
constexpr int MostRefinements = 30;

class HoleCutter
{
public:
  HoleCutter(const TriangleMesh& closed, const GeodesicHoleOptions& options)
    : Closed(closed)
    , Options(options)
    , Surface(closed)
    , Mesh(this->Surface.mesh())
    , TotalArea(faceAreas(closed.Vertices, closed.Faces).sum())
    , HoleArea(options.AreaFraction * this->TotalArea)
  {
  }

  OpenedSurface cut(const ProgressCallback& progress)
  {
    this->placeCentre(subrange(progress, 0.0, 0.4));
    report(progress, 0.4, "refining around the hole");
    this->refineBall();
    for (int i = 0;; ++i)
    {
      report(progress, std::min(0.9, 0.5 + 0.1 * i), "measuring distances around the hole");
      this->measure();
      const std::vector<Face> coarse = this->coarseFacesAtCurve();
      if (coarse.empty())
      {
        break;
      }
      if (i == MostRefinements)
      {
        throw TopologyError("no round hole of share " + std::to_string(this->Options.AreaFraction) +
                            " of the area can be cut there: choose another hole point or area");
      }
      bisectLongEdges(this->Surface, coarse, this->longestCrossedEdge());
    }
    report(progress, 0.9, "cutting the hole");
    this->splitAtCurve();
    this->removeInside();

    OpenedSurface opened;
    opened.Centre = this->Centre;
    opened.Radius = this->Radius;
    opened.RemovedArea = this->TotalArea;
    const TriangleMesh rest = toTriangleMesh(this->Mesh);
    opened.RemovedArea -= faceAreas(rest.Vertices, rest.Faces).sum();
    collapseShortEdgesAtBoundary(this->Surface, this->Options.BoundaryVertices);
    opened.Surface = this->Surface.derived();
    return opened;
  }

private:
  void placeCentre(const ProgressCallback& progress)
  {
    if (this->Options.Centre)
    {
      const SurfacePoint nearest = SurfaceProjection(this->Closed).closest(*this->Options.Centre);
      this->Centre = nearest.Position;
      this->CentreFace = nearest.Face;
    }
    else
    {
      const int centre = geodesicCentre(this->Closed, progress);
      this->Centre = this->Closed.Vertices.row(centre);
      this->CentreFace = static_cast<int>(this->Mesh.face(this->Mesh.halfedge(Vertex(centre))).idx());
    }
  }

  Kernel::Point_3 centrePoint() const
  {
    return { this->Centre.x(), this->Centre.y(), this->Centre.z() };
  }

  double squaredDistance(Face face) const
  {
    const Halfedge h = this->Mesh.halfedge(face);
    return CGAL::to_double(CGAL::squared_distance(this->centrePoint(),
      Kernel::Triangle_3(this->Mesh.point(this->Mesh.source(h)),
        this->Mesh.point(this->Mesh.target(h)),
        this->Mesh.point(this->Mesh.target(this->Mesh.next(h))))));
  }

  double longestEdge(Face face) const
  {
    double longest = 0.0;
    for (const Halfedge h : this->Mesh.halfedges_around_face(this->Mesh.halfedge(face)))
    {
      longest = std::max(longest, this->Surface.squaredLength(h));
    }
    return std::sqrt(longest);
  }

  // The part of the original face CentreFace that the centre lies on.
  Face faceAtCentre()
  {
    Face nearest = SurfaceMesh::null_face();
    double distance = HUGE_VAL;
    for (const Face face : this->Mesh.faces())
    {
      if (this->Surface.origin(face) == this->CentreFace && this->squaredDistance(face) < distance)
      {
        distance = this->squaredDistance(face);
        nearest = face;
      }
    }
    return nearest;
  }

  // Faces connected to the centre within a Euclidean ball; not those of other folds.
  std::vector<Face> facesInBall(double radius)
  {
    std::vector<Face> faces{ this->faceAtCentre() };
    std::vector<char> visited(this->Mesh.num_faces(), 0);
    visited[faces.front()] = 1;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      for (const Face next : this->Mesh.faces_around_face(this->Mesh.halfedge(faces[i])))
      {
        if (!visited[next] && this->squaredDistance(next) < radius * radius)
        {
          visited[next] = 1;
          faces.push_back(next);
        }
      }
    }
    return faces;
  }

  // A first guess, as if the surface were flat here; halved edge by edge so that big faces are refined
  // near the hole only.
  void refineBall()
  {
    const double radius = std::sqrt(this->HoleArea / Pi);
    const double wanted = EdgePerSpacing * 2.0 * Pi * radius / this->Options.BoundaryVertices;
    double longest = 0.0;
    for (const Face face : this->facesInBall(RingWidth * radius))
    {
      longest = std::max(longest, this->longestEdge(face));
    }
    while (longest > wanted)
    {
      longest = std::max(wanted, 0.5 * longest);
      bisectLongEdges(this->Surface, this->facesInBall(RingWidth * radius), longest);
    }
  }

  Vertex centreVertex()
  {
    const Face face = this->faceAtCentre();
    Vertex nearest;
    double distance = HUGE_VAL;
    for (const Vertex v : this->Mesh.vertices_around_face(this->Mesh.halfedge(face)))
    {
      const double d = CGAL::squared_distance(this->centrePoint(), this->Mesh.point(v));
      if (d < distance)
      {
        distance = d;
        nearest = v;
      }
    }
    return nearest;
  }

  // Faces nearest to the centre along edges, of the given total area at least.
  std::vector<Face> neighbourhood(Vertex centre, double area) const
  {
    using Entry = std::pair<double, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::vector<double> distance(this->Mesh.num_vertices(), HUGE_VAL);
    std::vector<char> taken(this->Mesh.num_faces(), 0);
    std::vector<Face> faces;
    distance[centre] = 0.0;
    queue.emplace(0.0, centre);
    double sum = 0.0;
    while (!queue.empty() && sum < area)
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distance[v])
      {
        continue;
      }
      for (const Halfedge h : this->Mesh.halfedges_around_target(this->Mesh.halfedge(v)))
      {
        const Face face = this->Mesh.face(h);
        if (!taken[face])
        {
          taken[face] = 1;
          faces.push_back(face);
          sum += this->area(face);
        }
        const Vertex w = this->Mesh.source(h);
        const double length = d + std::sqrt(this->Surface.squaredLength(h));
        if (length < distance[w])
        {
          distance[w] = length;
          queue.emplace(length, w);
        }
      }
    }
    return faces;
  }

  double area(Face face) const
  {
    const Halfedge h = this->Mesh.halfedge(face);
    const Kernel::Point_3& p = this->Mesh.point(this->Mesh.source(h));
    const auto normal = CGAL::cross_product(this->Mesh.point(this->Mesh.target(h)) - p,
      this->Mesh.point(this->Mesh.target(this->Mesh.next(h))) - p);
    return 0.5 * std::sqrt(normal.squared_length());
  }

  // Sets Distance, Radius and Spacing from the heat method on the neighbourhood of the centre.
  void measure()
  {
    const Vertex centre = this->centreVertex();
    const TriangleMesh whole = toTriangleMesh(this->Mesh);
    std::vector<int> faces;
    for (const Face face : this->neighbourhood(centre, NeighbourhoodAreas * this->HoleArea))
    {
      faces.push_back(static_cast<int>(face.idx()));
    }
    std::sort(faces.begin(), faces.end());
    const DerivedMesh part = extractFaces(whole, faces);

    std::vector<int> original(part.Mesh.vertexCount());
    int source = -1;
    for (int v = 0; v < part.Mesh.vertexCount(); ++v)
    {
      original[v] = VertexOrigins::InnerIterator(part.Vertices, v).col();
      source = original[v] == static_cast<int>(centre.idx()) ? v : source;
    }
    const Eigen::VectorXd distances = geodesicDistances(part.Mesh, source);
    this->Radius = levelEnclosingArea(part.Mesh, distances, this->HoleArea);
    this->Spacing =
      levelCurveLength(part.Mesh, distances, this->Radius) / this->Options.BoundaryVertices;
    this->Distance.assign(this->Mesh.num_vertices(), HUGE_VAL);
    for (int v = 0; v < part.Mesh.vertexCount(); ++v)
    {
      this->Distance[original[v]] = distances[v];
    }
  }

  double longestCrossedEdge() const { return EdgePerSpacing * this->Spacing; }

  std::vector<Face> coarseFacesAtCurve() const
  {
    std::vector<Face> coarse;
    for (const Face face : this->Mesh.faces())
    {
      double low = HUGE_VAL;
      double high = 0.0;
      for (const Vertex v : this->Mesh.vertices_around_face(this->Mesh.halfedge(face)))
      {
        low = std::min(low, this->Distance[v]);
        high = std::max(high, this->Distance[v]);
      }
      if (low <= RingWidth * this->Radius && high >= this->Radius / RingWidth &&
          this->longestEdge(face) > this->longestCrossedEdge())
      {
        coarse.push_back(face);
      }
    }
    return coarse;
  }

  bool isInside(Vertex v) const { return this->Distance[v] < this->Radius; }

  // Afterwards no edge crosses the curve: every face lies on one side.
  void splitAtCurve()
  {
    std::vector<Halfedge> crossed;
    for (const auto edge : this->Mesh.edges())
    {
      const Halfedge h = this->Mesh.halfedge(edge);
      if (this->isInside(this->Mesh.source(h)) != this->isInside(this->Mesh.target(h)))
      {
        crossed.push_back(h);
      }
    }
    for (const Halfedge h : crossed)
    {
      const double from = this->Distance[this->Mesh.source(h)];
      const double to = this->Distance[this->Mesh.target(h)];
      // A curve through a vertex still gives an edge of some length, which is collapsed later.
      const double t = std::clamp((this->Radius - from) / (to - from), 1e-6, 1.0 - 1e-6);
      const Vertex middle = this->Surface.splitEdge(h, t).Middle;
      this->Distance.resize(this->Mesh.num_vertices());
      this->Distance[middle] = this->Radius;
    }
  }

  void removeInside()
  {
    const auto inside = [this](Face face)
    {
      for (const Vertex v : this->Mesh.vertices_around_face(this->Mesh.halfedge(face)))
      {
        if (this->isInside(v))
        {
          return true;
        }
      }
      return false;
    };
    std::vector<Face> hole{ this->faceAtCentre() };
    std::vector<char> visited(this->Mesh.num_faces(), 0);
    visited[hole.front()] = 1;
    for (std::size_t i = 0; i < hole.size(); ++i)
    {
      for (const Face next : this->Mesh.faces_around_face(this->Mesh.halfedge(hole[i])))
      {
        if (!visited[next] && inside(next))
        {
          visited[next] = 1;
          hole.push_back(next);
        }
      }
    }
    for (const Face face : hole)
    {
      CGAL::Euler::remove_face(this->Mesh.halfedge(face), this->Mesh);
    }
    auto size = this->Mesh.add_property_map<Face, double>("f:area", 0.0).first;
    for (const Face face : this->Mesh.faces())
    {
      size[face] = this->area(face);
    }
    CGAL::Polygon_mesh_processing::keep_largest_connected_components(
      this->Mesh, 1, CGAL::parameters::face_size_map(size));
  }

  const TriangleMesh& Closed;
  const GeodesicHoleOptions& Options;
  EditableSurface Surface;
  SurfaceMesh& Mesh;
  double TotalArea;
  double HoleArea;
  Eigen::Vector3d Centre;
  int CentreFace = -1;          // of Closed
  std::vector<double> Distance; // of every vertex from the centre; infinite beyond the neighbourhood
  double Radius = 0.0;
  double Spacing = 0.0; // of the boundary vertices asked for
};

} // namespace

OpenedSurface cutGeodesicHole(const TriangleMesh& closed,
  const GeodesicHoleOptions& options,
  const ProgressCallback& progress)
{
  if (!(options.AreaFraction > 0.0 && options.AreaFraction <= 0.5))
  {
    throw InvalidInput("the hole's share of the area is " + std::to_string(options.AreaFraction) +
                       ": set it above 0 and to 0.5 at most");
  }
  if (options.BoundaryVertices < 3)
  {
    throw InvalidInput("a boundary of " + std::to_string(options.BoundaryVertices) +
                       " vertices was asked for: ask for 3 at least");
  }
  if (options.Centre && !options.Centre->allFinite())
  {
    throw InvalidInput("the hole's point is not finite: set all of its coordinates");
  }
  return HoleCutter(closed, options).cut(progress);
}

} // namespace flattening
