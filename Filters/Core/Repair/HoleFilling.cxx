// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/HoleFilling.h"

#include "Base/Errors.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/HoleTriangulation.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/SelfIntersections.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Vertex = EditableSurface::Vertex;
using Halfedge = EditableSurface::Halfedge;
using Face = EditableSurface::Face;

// Joins a new vertex in the middle to the whole loop, which fits whatever edges exist already.
void coverWithFan(EditableSurface& surface, Halfedge border, const std::vector<Vertex>& loop)
{
  SurfaceMesh& mesh = surface.mesh();
  Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
  Origin origin;
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

// Sets the origins of new vertices: the corners of the unrefined patch, which has only the loop's
// vertices, below them.
void traceToLoop(EditableSurface& surface,
  const std::vector<Vertex>& loop,
  const TriangleMesh& patch,
  const std::vector<Vertex>& added)
{
  if (added.empty())
  {
    return;
  }
  const ClosestPointTree projection(patch);
  for (const Vertex v : added)
  {
    const Kernel::Point_3& p = surface.mesh().point(v);
    const SurfacePoint at = projection.closest({ p.x(), p.y(), p.z() });
    surface.origin(v) = originOf(patch.Faces, at.Face, at.Weights);
    for (auto& [original, weight] : surface.origin(v))
    {
      original = surface.origin(loop[original]).front().first;
    }
  }
}

// The faces as a mesh whose vertices are those of the loop, in its order.
TriangleMesh unrefinedPatch(const SurfaceMesh& mesh,
  const std::vector<Vertex>& loop,
  const std::vector<Face>& faces)
{
  std::map<Vertex, int> index;
  TriangleMesh patch;
  patch.Vertices.resize(static_cast<Eigen::Index>(loop.size()), 3);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Kernel::Point_3& p = mesh.point(loop[i]);
    patch.Vertices.row(i) << p.x(), p.y(), p.z();
    index[loop[i]] = static_cast<int>(i);
  }
  patch.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    int k = 0;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(faces[f])))
    {
      patch.Faces(f, k++) = index.at(v);
    }
  }
  return patch;
}

// Ways to cover a hole, in the order in which they are tried.
enum class Patch
{
  Refined,
  Delaunay,
  LeastAngle,
  Fan
};

void fillHole(EditableSurface& surface, Halfedge border, Patch kind)
{
  SurfaceMesh& mesh = surface.mesh();
  const auto corners = mesh.vertices_around_face(border);
  const std::vector<Vertex> loop(corners.begin(), corners.end());
  std::vector<Face> patch;
  if (kind != Patch::Fan)
  {
    patch = triangulateHole(mesh, border, kind != Patch::LeastAngle);
  }
  if (patch.empty())
  {
    coverWithFan(surface, border, loop);
    return;
  }
  if (kind == Patch::Refined)
  {
    const TriangleMesh unrefined = unrefinedPatch(mesh, loop, patch);
    traceToLoop(surface, loop, unrefined, refineFaces(mesh, patch));
  }
}

struct PatchedSurface
{
  DerivedMesh Surface;
  std::vector<std::vector<int>> Patches; ///< the faces that cover each hole

  // For each hole the number of faces, old or new, that its patch intersects.
  std::vector<int> intersections() const
  {
    return intersectionsPerGroup(this->Surface.Mesh, this->Patches);
  }
};

PatchedSurface patched(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  const std::vector<Patch>& kinds,
  const ProgressCallback& progress)
{
  EditableSurface surface(mesh);
  PatchedSurface result;
  for (std::size_t hole = 0; hole < loops.size(); ++hole)
  {
    report(progress, static_cast<double>(hole) / loops.size(), "filling holes");
    const auto faces = static_cast<int>(surface.mesh().number_of_faces());
    const int vertex = loops[hole].front();
    const auto border = CGAL::is_border(Vertex(vertex), surface.mesh());
    if (!border)
    {
      throw InvalidInput("vertex " + std::to_string(vertex) + " is not on the boundary");
    }
    fillHole(surface, *border, kinds[hole]);
    std::vector<int>& patch = result.Patches.emplace_back(surface.mesh().number_of_faces() - faces);
    std::iota(patch.begin(), patch.end(), faces);
  }
  result.Surface = surface.derived();
  return result;
}

// The error message says where a loop that is too long lies.
void requireShort(const TriangleMesh& mesh, const std::vector<int>& loop, double limit)
{
  const double length = loopLength(mesh.Vertices, loop);
  if (length > limit)
  {
    Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
    for (const int v : loop)
    {
      centre += mesh.Vertices.row(v) / static_cast<double>(loop.size());
    }
    std::ostringstream message; // lengths of any order of magnitude
    message << "the hole around (" << centre[0] << ", " << centre[1] << ", " << centre[2] << ") is "
            << length << " long, more than the limit of " << limit
            << " for holes that are filled: raise the limit, or cut that part off with Clip";
    throw InvalidInput(message.str());
  }
}

} // namespace

FilledSurface fillHoles(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  double longestLoop,
  const ProgressCallback& progress)
{
  for (const std::vector<int>& loop : loops)
  {
    requireShort(mesh, loop, longestLoop);
  }
  const int holes = static_cast<int>(loops.size());
  std::vector<Patch> kinds(holes, Patch::Refined);
  PatchedSurface filled = patched(mesh, loops, kinds, subrange(progress, 0.0, 0.4));
  std::vector<int> fewest = filled.intersections();

  const auto intersects = [](int count) { return count > 0; };
  double done = 0.4;
  for (const Patch kind : { Patch::Delaunay, Patch::LeastAngle, Patch::Fan })
  {
    if (std::none_of(fewest.begin(), fewest.end(), intersects))
    {
      break;
    }
    report(progress, done, "filling holes");
    done += 0.15;
    std::vector<Patch> tried = kinds;
    for (int hole = 0; hole < holes; ++hole)
    {
      tried[hole] = intersects(fewest[hole]) ? kind : kinds[hole];
    }
    const std::vector<int> counts = patched(mesh, loops, tried, {}).intersections();
    for (int hole = 0; hole < holes; ++hole)
    {
      if (counts[hole] < fewest[hole])
      {
        kinds[hole] = tried[hole];
        fewest[hole] = counts[hole];
      }
    }
    filled = patched(mesh, loops, kinds, {});
    fewest = filled.intersections();
  }

  FilledSurface result;
  result.FilledHoles = holes;
  result.IntersectingPatches = static_cast<int>(std::count_if(fewest.begin(), fewest.end(), intersects));
  result.Surface = std::move(filled.Surface);
  const TriangleMesh& surface = result.Surface.Mesh;
  const Eigen::VectorXd areas = faceAreas(surface.Vertices, surface.Faces);
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    result.FilledArea += result.Surface.Faces[f] < 0 ? areas[f] : 0.0;
  }
  return result;
}

} // namespace flattening
