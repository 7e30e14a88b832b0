// SPDX-License-Identifier: GPL-3.0-or-later
#include "HoleFilling.h"

#include "EditableSurface.h"
#include "Errors.h"
#include "SurfaceProjection.h"

#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;
using Vertex = EditableSurface::Vertex;
using Halfedge = EditableSurface::Halfedge;
using Face = EditableSurface::Face;

// Up to here the search of all triangulations, O(n^3), takes seconds at most if the faster ones fail.
constexpr std::size_t LongestCubicLoop = 500;

// The border half-edge that ends in a boundary vertex.
Halfedge borderAt(const SurfaceMesh& mesh, Vertex v)
{
  for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
  {
    if (mesh.is_border(h))
    {
      return h;
    }
  }
  throw InvalidInput("vertex " + std::to_string(v.idx()) + " is not on the boundary");
}

std::vector<Vertex> loopVertices(const SurfaceMesh& mesh, Halfedge border)
{
  std::vector<Vertex> loop;
  for (const Halfedge h : mesh.halfedges_around_face(border))
  {
    loop.push_back(mesh.target(h));
  }
  return loop;
}

// A vertex in the middle, joined to the whole loop: always fits, whatever edges exist.
void coverWithFan(EditableSurface& surface, Halfedge border, const std::vector<Vertex>& loop)
{
  SurfaceMesh& mesh = surface.mesh();
  Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
  EditableSurface::Origin origin;
  for (const Vertex v : loop)
  {
    sum += mesh.point(v) - CGAL::ORIGIN;
    origin.emplace_back(surface.origin(v).front().first, 1.0 / static_cast<double>(loop.size()));
  }
  CGAL::Euler::fill_hole(border, mesh);
  const Halfedge spoke = CGAL::Euler::add_center_vertex(border, mesh);
  const Vertex centre = mesh.target(spoke);
  mesh.point(centre) = CGAL::ORIGIN + sum / static_cast<double>(loop.size());
  surface.origin(centre) = origin;
}

// New vertices take their attributes from the unrefined patch, which has the loop's vertices only.
void traceToLoop(EditableSurface& surface,
  const std::vector<Vertex>& loop,
  const TriangleMesh& patch,
  const std::vector<Vertex>& added)
{
  if (added.empty())
  {
    return;
  }
  const SurfaceProjection projection(patch);
  for (const Vertex v : added)
  {
    const Kernel::Point_3& p = surface.mesh().point(v);
    const SurfacePoint at = projection.closest({ p.x(), p.y(), p.z() });
    EditableSurface::Origin origin;
    for (int k = 0; k < 3; ++k)
    {
      if (at.Weights[k] > 0.0)
      {
        const Vertex corner = loop[patch.Faces(at.Face, k)];
        origin.emplace_back(surface.origin(corner).front().first, at.Weights[k]);
      }
    }
    surface.origin(v) = origin;
  }
}

TriangleMesh unrefinedPatch(const SurfaceMesh& mesh,
  const std::vector<Vertex>& loop,
  const std::vector<Face>& faces)
{
  std::vector<std::pair<Vertex, int>> position;
  TriangleMesh patch;
  patch.Vertices.resize(static_cast<Eigen::Index>(loop.size()), 3);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Kernel::Point_3& p = mesh.point(loop[i]);
    patch.Vertices.row(i) << p.x(), p.y(), p.z();
    position.emplace_back(loop[i], static_cast<int>(i));
  }
  std::sort(position.begin(), position.end());
  patch.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    int k = 0;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(faces[f])))
    {
      patch.Faces(f, k++) =
        std::lower_bound(position.begin(), position.end(), std::make_pair(v, 0))->second;
    }
  }
  return patch;
}

void fillHole(EditableSurface& surface, Halfedge border)
{
  SurfaceMesh& mesh = surface.mesh();
  const std::vector<Vertex> loop = loopVertices(mesh, border);
  std::vector<Face> patch;
  PMP::triangulate_hole(mesh,
    border,
    std::back_inserter(patch),
    CGAL::parameters::use_2d_constrained_delaunay_triangulation(true).do_not_use_cubic_algorithm(
      loop.size() > LongestCubicLoop));
  if (patch.empty())
  {
    coverWithFan(surface, border, loop);
    return;
  }
  const TriangleMesh unrefined = unrefinedPatch(mesh, loop, patch);
  std::vector<Vertex> added;
  std::vector<Face> refined;
  PMP::refine(mesh, patch, std::back_inserter(refined), std::back_inserter(added));
  traceToLoop(surface, loop, unrefined, added);
}

} // namespace

double loopLength(const Points3& vertices, const std::vector<int>& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += (vertices.row(loop[i]) - vertices.row(loop[(i + 1) % loop.size()])).norm();
  }
  return length;
}

FilledSurface fillHoles(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  const ProgressCallback& progress)
{
  EditableSurface surface(mesh);
  FilledSurface result;
  for (const std::vector<int>& loop : loops)
  {
    report(progress, static_cast<double>(result.FilledHoles) / loops.size(), "filling holes");
    fillHole(surface, borderAt(surface.mesh(), Vertex(loop.front())));
    ++result.FilledHoles;
  }

  result.Surface = surface.derived();
  const TriangleMesh& filled = result.Surface.Mesh;
  const Eigen::VectorXd areas = faceAreas(filled.Vertices, filled.Faces);
  for (int f = 0; f < filled.faceCount(); ++f)
  {
    result.FilledArea += result.Surface.Faces[f] < 0 ? areas[f] : 0.0;
  }
  return result;
}

} // namespace flattening
