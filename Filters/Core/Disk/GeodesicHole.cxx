// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/GeodesicHole.h"

#include "Disk/HolePlacement.h"
#include "Disk/IsolineCut.h"
#include "Geodesics/FaceNeighbourhoods.h"
#include "Geodesics/GeodesicDistance.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfacePick.h"
#include "Remeshing/BoundaryConditioning.h"
#include "Remeshing/LongestEdgeBisection.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Vertex = EditableSurface::Vertex;
using Halfedge = EditableSurface::Halfedge;
using Face = EditableSurface::Face;

constexpr double Pi = EIGEN_PI;
// The longest edge that the isoline may cross, in mean distances of the boundary vertices asked for.
// Derived: an isoline crosses more than two edges per edge length, so enough vertices are left after
// short edges are collapsed. Smaller values refine more, larger ones need more rounds.
constexpr double EdgePerSpacing = 1.25;
// The factor on that length if the isoline still crosses too few edges. A convention: between 0 and 1,
// small factors overshoot and factors near 1 need many rounds.
constexpr double HoleRefinement = 0.7;
// A guard against endless refinement: so many rounds make edges shorter by a factor of 40,000 at least.
constexpr int MostHoleRounds = 30;
// The least share to which a round shortens the longest edges along the isoline. A choice: with more,
// faces of ordinary shapes need more than one round; with less, long faces that the isoline only touches
// are refined over their whole length.
constexpr double ShorterPerRound = 0.25;
// The mesh is refined this many spacings to either side of the isoline, which still moves a little from
// round to round. A convention: with less, more rounds are needed.
constexpr double RingSpacings = 4.0;
// The first refinement, which makes a mesh fine enough to find the isoline at all: a ball of this many
// radii, with this many edges per radius. Conventions.
constexpr double BallRadii = 1.25;
constexpr double BallEdges = 16.0;
// The distance is computed on a neighbourhood of this many times the hole's area. Derived: its border is
// then more than twice the radius away, where it has no influence on the isoline.
constexpr double NeighbourhoodAreas = 6.0;
// Distance of the centre from the region to be avoided, in radii of a flat hole. Derived: paths along
// edges are up to 1.4 times as long as straight ones, and the isoline is not quite a circle.
constexpr double HoleClearance = 2.0;

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
    this->refineAlongCurve(subrange(progress, 0.5, 0.9));
    report(progress, 0.9, "cutting the hole");
    splitAtIsoline(this->Surface, this->Distance, this->Radius);
    this->removeInside();

    OpenedSurface opened;
    opened.RemovedAvoided = this->removedAvoided();
    opened.Centre = this->Centre;
    opened.Radius = this->Radius;
    opened.RemovedArea = this->TotalArea;
    const TriangleMesh rest = toTriangleMesh(this->Mesh);
    opened.RemovedArea -= faceAreas(rest.Vertices, rest.Faces).sum();
    conditionBoundary(this->Surface, this->Options.BoundaryVertices);
    opened.Surface = this->Surface.derived();
    return opened;
  }

private:
  void placeCentre(const ProgressCallback& progress)
  {
    if (this->Options.Centre)
    {
      const SurfacePoint nearest = pickOnSurface(ClosestPointTree(this->Closed),
        boxDiagonal(this->Closed),
        *this->Options.Centre,
        "the hole's point");
      this->Centre = nearest.Position;
      this->CentreFace = nearest.Face;
    }
    else
    {
      const double clearance = HoleClearance * std::sqrt(this->HoleArea / Pi);
      const int centre = geodesicCentre(this->Closed, this->Options.Avoided, clearance, progress);
      this->Centre = this->Closed.Vertices.row(centre);
      this->CentreFace = static_cast<int>(this->Mesh.face(this->Mesh.halfedge(Vertex(centre))).idx());
    }
  }

  Kernel::Point_3 centrePoint() const
  {
    return { this->Centre.x(), this->Centre.y(), this->Centre.z() };
  }

  Face faceAtCentre() const { return partAt(this->Surface, this->CentreFace, this->centrePoint()); }

  double longestEdge(const std::vector<Face>& faces) const
  {
    double longest = 0.0;
    for (const Face face : faces)
    {
      longest = std::max(longest, this->Surface.longestEdge(face));
    }
    return longest;
  }

  // Refines a ball around the centre whose radius is that of a flat hole. The longest edges are halved
  // round by round: big faces are refined near the hole only.
  void refineBall()
  {
    const double radius = std::sqrt(this->HoleArea / Pi);
    const double wanted = radius / BallEdges;
    const auto faces = [this, radius]
    { return facesInBall(this->Mesh, this->faceAtCentre(), this->centrePoint(), BallRadii * radius); };
    double longest = this->longestEdge(faces());
    while (longest > wanted)
    {
      longest = std::max(wanted, 0.5 * longest);
      bisectLongEdges(this->Surface, faces(), longest);
    }
  }

  // Refines until the isoline of the distance crosses enough edges, all of them short.
  void refineAlongCurve(const ProgressCallback& progress)
  {
    double edgePerSpacing = EdgePerSpacing;
    for (int round = 0; round < MostHoleRounds; ++round)
    {
      report(progress, std::min(1.0, 0.25 * round), "measuring distances around the hole");
      this->measure();
      if (crossesMoreThanEnough(
            this->Mesh, this->Distance, this->Radius, this->Options.BoundaryVertices))
      {
        return;
      }
      if (this->facesAtIsoline(0.0, EdgeLengthSlack * edgePerSpacing * this->Spacing).empty())
      {
        if (static_cast<int>(edgesAcrossIsoline(this->Mesh, this->Distance, this->Radius).size()) >=
            this->Options.BoundaryVertices)
        {
          return;
        }
        edgePerSpacing *= HoleRefinement;
      }
      const double wanted = edgePerSpacing * this->Spacing;
      const std::vector<Face> faces = this->facesAtIsoline(RingSpacings * this->Spacing, wanted);
      bisectLongEdges(
        this->Surface, faces, std::max(wanted, ShorterPerRound * this->longestEdge(faces)));
    }
    this->throwNoHole();
  }

  [[noreturn]] void throwNoHole() const
  {
    throw TopologyError("no round hole of share " + formatted(this->Options.AreaFraction) +
                        " of the area with " + std::to_string(this->Options.BoundaryVertices) +
                        " vertices or more can be cut there: lower Minimum Boundary Vertices, or choose "
                        "another hole point or area");
  }

  Vertex centreVertex() const
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

  // Sets Distance, Radius and Spacing from the heat method on the neighbourhood of the centre.
  void measure()
  {
    const Vertex centre = this->centreVertex();
    const TriangleMesh whole = toTriangleMesh(this->Mesh);
    std::vector<int> faces;
    for (const Face face : facesNearestTo(this->Surface, centre, NeighbourhoodAreas * this->HoleArea))
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
    if (!(this->Spacing > 0.0))
    {
      this->throwNoHole();
    }
    this->Distance.assign(this->Mesh.num_vertices(), HUGE_VAL);
    for (int v = 0; v < part.Mesh.vertexCount(); ++v)
    {
      this->Distance[original[v]] = distances[v];
    }
    raiseValuesAt(this->Distance, this->Radius);
  }

  std::vector<Face> facesAtIsoline(double distance, double longest) const
  {
    return longFacesAtIsoline(this->Surface, this->Distance, this->Radius, distance, longest);
  }

  bool isInside(Vertex v) const { return this->Distance[v] < this->Radius; }

  bool reachesInside(Face face) const
  {
    const auto corners = this->Mesh.vertices_around_face(this->Mesh.halfedge(face));
    return std::any_of(corners.begin(), corners.end(), [this](Vertex v) { return this->isInside(v); });
  }

  // Removes the faces inside the isoline that are connected to the centre, and the parts of the surface
  // that these separated from the largest one.
  void removeInside()
  {
    std::vector<Face> hole{ this->faceAtCentre() };
    std::vector<char> visited(this->Mesh.num_faces(), 0);
    visited[hole.front()] = 1;
    for (std::size_t i = 0; i < hole.size(); ++i)
    {
      for (const Face next : this->Mesh.faces_around_face(this->Mesh.halfedge(hole[i])))
      {
        if (!visited[next] && this->reachesInside(next))
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
      size[face] = this->Surface.area(face);
    }
    CGAL::Polygon_mesh_processing::keep_largest_connected_components(
      this->Mesh, 1, CGAL::parameters::face_size_map(size));
  }

  int removedAvoided() const
  {
    int removed = 0;
    for (std::size_t v = 0; v < this->Options.Avoided.size(); ++v)
    {
      removed +=
        this->Options.Avoided[v] && this->Mesh.is_removed(Vertex(static_cast<SurfaceMesh::size_type>(v)))
          ? 1
          : 0;
    }
    return removed;
  }

  const TriangleMesh& Closed;
  const GeodesicHoleOptions& Options;
  EditableSurface Surface;
  SurfaceMesh& Mesh;
  double TotalArea;
  double HoleArea;
  Eigen::Vector3d Centre;
  int CentreFace = -1;          // the face of Closed that the centre lies on
  std::vector<double> Distance; // per vertex, from the centre; infinite beyond the neighbourhood
  double Radius = 0.0;
  double Spacing = 0.0; // mean distance of the boundary vertices asked for
};

} // namespace

OpenedSurface cutGeodesicHole(const TriangleMesh& closed,
  const GeodesicHoleOptions& options,
  const ProgressCallback& progress)
{
  if (!(options.AreaFraction > 0.0 && options.AreaFraction <= 0.5))
  {
    throw InvalidInput("the hole's share of the area is " + formatted(options.AreaFraction) +
                       ": set it above 0 and to 0.5 at most");
  }
  if (options.BoundaryVertices < 3)
  {
    throw InvalidInput("a boundary of " + std::to_string(options.BoundaryVertices) +
                       " vertices was asked for: ask for 3 at least");
  }
  const MeshTopology topology = analyseTopology(closed.Faces, closed.vertexCount());
  if (topology.Components != 1 || !topology.BoundaryLoops.empty())
  {
    throw TopologyError("a hole can be cut into one closed surface only; this one has " +
                        std::to_string(topology.Components) + " components and " +
                        std::to_string(topology.BoundaryLoops.size()) +
                        " boundary loops: run Surface To Disk");
  }
  OpenedSurface opened = HoleCutter(closed, options).cut(progress);
  const TriangleMesh& rest = opened.Surface.Mesh;
  const MeshTopology left = analyseTopology(rest.Faces, rest.vertexCount());
  if (left.Genus != topology.Genus || left.BoundaryLoops.size() != 1)
  {
    throw TopologyError("a hole of share " + formatted(options.AreaFraction) +
                        " of the area reaches around a handle or tunnel there: choose another hole "
                        "point or a smaller area");
  }
  return opened;
}

} // namespace flattening
