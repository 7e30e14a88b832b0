// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/RegionPreservingDecimation.h"

#include "Base/Errors.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/EditableSurface.h"

#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>

namespace flattening
{
namespace
{

namespace simplification = CGAL::Surface_mesh_simplification;

using Vertex = SurfaceMesh::Vertex_index;
using Fixed = SurfaceMesh::Property_map<SurfaceMesh::Edge_index, bool>;
using Origins = SurfaceMesh::Property_map<Vertex, int>; // -1 for a new vertex

// An abort is noticed after so many edges.
constexpr int DecimationReportInterval = 1 << 12;

void requireFits(const TriangleMesh& mesh, const std::vector<char>& inRegion, int contextFaces)
{
  if (static_cast<int>(inRegion.size()) != mesh.vertexCount())
  {
    throw InvalidInput("there are " + std::to_string(inRegion.size()) + " flags for " +
                       std::to_string(mesh.vertexCount()) + " vertices: pass one for each");
  }
  if (contextFaces < 1)
  {
    throw InvalidInput(
      "the context is to have " + std::to_string(contextFaces) + " faces: set a positive number");
  }
  if (std::none_of(inRegion.begin(), inRegion.end(), [](char in) { return in != 0; }))
  {
    throw InvalidInput("no point is in a region: choose an array that is not 0 in the regions, or use "
                       "Remesh in Surface To Disk for the whole surface");
  }
  if (!mesh.Vertices.allFinite())
  {
    throw InvalidInput("the surface has a coordinate that is not finite: remove such points first");
  }
}

// Flags the faces that must stay: those with a corner in a region.
std::vector<char> facesToKeep(const TriangleMesh& mesh, const std::vector<char>& inRegion)
{
  std::vector<char> keep(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    const auto face = mesh.Faces.row(f);
    keep[f] = std::any_of(face.begin(), face.end(), [&inRegion](int v) { return inRegion[v] != 0; });
  }
  return keep;
}

// Flags the faces that collapses must leave: those to keep, and those around a vertex in which fans of
// faces meet. CGAL promises nothing of such a vertex, and takes a fan of a single face away from it.
std::vector<char> facesToFix(const SurfaceMesh& surface, std::vector<char> keep)
{
  std::vector<SurfaceMesh::Halfedge_index> sides; // one of each fan, towards the vertex
  CGAL::Polygon_mesh_processing::non_manifold_vertices(surface, std::back_inserter(sides));
  for (const auto side : sides)
  {
    for (const auto f : surface.faces_around_target(side))
    {
      if (f != SurfaceMesh::null_face())
      {
        keep[f.idx()] = 1;
      }
    }
  }
  return keep;
}

// Keeps track of the original vertices and reports progress.
struct Visitor : simplification::Edge_collapse_visitor_base<SurfaceMesh>
{
  Visitor(Origins origins, const std::vector<char>& fixed, const ProgressCallback& progress)
    : OriginOf(origins)
    , IsFixed(fixed)
    , Report(progress)
  {
  }

  template <typename Cost> // an optional of Boost in CGAL 5, of the standard library in CGAL 6
  void OnSelected(const Profile&, const Cost&, size_type initial, size_type current)
  {
    if (this->Selected++ % DecimationReportInterval == 0)
    {
      report(this->Report,
        0.8 * (1.0 - static_cast<double>(current) / static_cast<double>(initial)),
        "collapsing edges");
    }
  }

  template <typename Place>
  void OnCollapsing(const Profile& profile, const Place& place)
  {
    const bool isFirst = place && *place == profile.p0();
    const bool isSecond = place && *place == profile.p1();
    this->Next = isFirst    ? this->keptOf(profile, isSecond)
                 : isSecond ? this->OriginOf[profile.v1()]
                            : -1;
  }

  // CGAL collapses edges without length at first, and does not announce them.
  void OnCollapsed(const Profile& profile, const vertex_descriptor& kept)
  {
    this->OriginOf[kept] = this->Next.value_or(this->keptOf(profile, true));
    this->Next.reset();
  }

  // The original vertex at the first end of an edge; if the ends are at the same place, the fixed one.
  int keptOf(const Profile& profile, bool areAtTheSamePlace) const
  {
    const int second = this->OriginOf[profile.v1()];
    return areAtTheSamePlace && this->isFixed(second) ? second : this->OriginOf[profile.v0()];
  }

  bool isFixed(int original) const { return original >= 0 && this->IsFixed[original]; }

  Origins OriginOf;
  const std::vector<char>& IsFixed; // of the original vertices
  ProgressCallback Report;
  long long Selected = 0;
  std::optional<int> Next; // of the vertex that a collapse leaves, if it was announced
};

// Ends the decimation. CGAL has this predicate under one name up to 5.6 and under another since.
struct FewerEdges
{
  template <typename Cost, typename Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t current) const
  {
    return current < this->Edges;
  }

  std::size_t Edges = 0;
};

Origins collapse(SurfaceMesh& surface,
  const std::vector<char>& keep,
  int contextFaces,
  const ProgressCallback& progress)
{
  Fixed fixed = surface.add_property_map<SurfaceMesh::Edge_index, bool>("e:fixed", false).first;
  Origins origins = surface.add_property_map<Vertex, int>("v:origin", -1).first;
  for (const Vertex v : surface.vertices())
  {
    origins[v] = static_cast<int>(v.idx());
  }
  const std::vector<char> fix = facesToFix(surface, keep);
  std::vector<char> isFixed(surface.number_of_vertices(), 0);
  for (const auto f : surface.faces())
  {
    for (const auto h : surface.halfedges_around_face(surface.halfedge(f)))
    {
      isFixed[surface.target(h).idx()] |= fix[f.idx()];
    }
  }
  for (const auto e : surface.edges())
  {
    fixed[e] = isFixed[surface.vertex(e, 0).idx()] && isFixed[surface.vertex(e, 1).idx()];
  }
  const auto kept = static_cast<double>(std::count(keep.begin(), keep.end(), 1));
  const auto faces = static_cast<double>(surface.number_of_faces());
  const double edgesPerFace = static_cast<double>(surface.number_of_edges()) / faces;
  const double edges = edgesPerFace * (kept + std::min<double>(contextFaces, faces - kept));
  const FewerEdges stop{ static_cast<std::size_t>(edges) };
  const simplification::Constrained_placement<simplification::LindstromTurk_placement<SurfaceMesh>,
    Fixed>
    placement(fixed);
  simplification::edge_collapse(surface,
    stop,
    CGAL::parameters::edge_is_constrained_map(fixed)
      .get_cost(simplification::LindstromTurk_cost<SurfaceMesh>())
      .get_placement(placement)
      .filter(simplification::Bounded_normal_change_filter<>())
      .visitor(Visitor(origins, isFixed, progress)));
  return origins;
}

} // namespace

DerivedMesh decimateContext(const TriangleMesh& mesh,
  const std::vector<char>& inRegion,
  int contextFaces,
  const ProgressCallback& progress)
{
  requireFits(mesh, inRegion, contextFaces);
  SurfaceMesh surface = toSurfaceMesh(mesh);
  const std::vector<char> keep = facesToKeep(mesh, inRegion);
  if (std::count(keep.begin(), keep.end(), 0) <= contextFaces)
  {
    report(progress, 1.0, "the surface is coarse enough");
    return derivedFromItself(mesh);
  }
  report(progress, 0.0, "collapsing edges");
  const Origins origins = collapse(surface, keep, contextFaces, progress);

  report(progress, 0.8, "carrying attributes over");
  const ClosestPointTree original(mesh);
  DerivedMesh derived;
  derived.Mesh = toTriangleMesh(surface);
  derived.Vertices = originMatrix(surface.vertices(),
    mesh.vertexCount(),
    [&](Vertex v)
    {
      if (origins[v] >= 0)
      {
        return Origin{ { origins[v], 1.0 } };
      }
      const Kernel::Point_3& p = surface.point(v);
      const SurfacePoint nearest = original.closest({ p.x(), p.y(), p.z() });
      // All three weights, as the new vertex is not the old one that may be nearest to it.
      Origin origin;
      for (int k = 0; k < 3; ++k)
      {
        origin.emplace_back(mesh.Faces(nearest.Face, k), nearest.Weights[k]);
      }
      return origin;
    });
  std::vector<int> kept; // per vertex: the original vertex that it is, or -1
  for (const Vertex v : surface.vertices())
  {
    kept.push_back(origins[v]);
  }
  for (const auto f : surface.faces()) // whose indices are those of the original faces
  {
    const int face = static_cast<int>(f.idx());
    const int row = static_cast<int>(derived.Faces.size());
    const Eigen::RowVector3i now = derived.Mesh.Faces.row(row);
    const Eigen::RowVector3i before = mesh.Faces.row(face);
    const Eigen::RowVector3i corners(kept[now[0]], kept[now[1]], kept[now[2]]);
    const bool isSame = std::is_permutation(corners.begin(), corners.end(), before.begin());
    const Eigen::Vector3d centroid =
      (derived.Mesh.Vertices.row(now[0]) + derived.Mesh.Vertices.row(now[1]) +
        derived.Mesh.Vertices.row(now[2]))
        .transpose() /
      3.0;
    derived.Faces.push_back(isSame ? face : original.closest(centroid).Face);
  }
  report(progress, 1.0, "done");
  return derived;
}

} // namespace flattening
