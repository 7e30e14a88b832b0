// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/HoleFilling.h"

#include "Base/Errors.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/EditableSurface.h"
#include "Mesh/HoleTriangulation.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/SelfIntersections.h"
#include "Repair/FaceList.h"

#include <algorithm>
#include <cstddef>
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

constexpr const char* FillingStage = "filling holes";

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

// The faces and vertices that cover a hole, apart from the surface. Corners are vertices of the surface
// or, numbered from its vertex count on, added ones.
struct HolePatch
{
  std::vector<Triangle> Faces;
  std::vector<Eigen::RowVector3d> Vertices; ///< the added ones
  std::vector<Origin> Origins;              ///< of these
};

// The elements that were added last, when the surface already had so many faces and vertices.
HolePatch lastPatch(EditableSurface& surface,
  std::size_t faces,
  std::size_t vertices,
  int originalVertices)
{
  const SurfaceMesh& mesh = surface.mesh();
  const int shift = static_cast<int>(vertices) - originalVertices;
  HolePatch patch;
  for (std::size_t f = faces; f < mesh.number_of_faces(); ++f)
  {
    Triangle& corners = patch.Faces.emplace_back();
    auto corner = corners.begin();
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(Face(f))))
    {
      const auto number = static_cast<int>(v.idx());
      *corner++ = number < originalVertices ? number : number - shift;
    }
  }
  for (std::size_t v = vertices; v < mesh.number_of_vertices(); ++v)
  {
    const Kernel::Point_3& p = mesh.point(Vertex(v));
    patch.Vertices.emplace_back(p.x(), p.y(), p.z());
    patch.Origins.push_back(surface.origin(Vertex(v)));
  }
  return patch;
}

// Makes patches of this kind for the holes that are chosen; those of the others stay as they are.
void makePatches(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  const std::vector<char>& chosen,
  Patch kind,
  std::vector<HolePatch>& patches,
  const ProgressCallback& progress)
{
  EditableSurface surface(mesh);
  for (std::size_t hole = 0; hole < loops.size(); ++hole)
  {
    if (!chosen[hole])
    {
      continue;
    }
    report(progress, static_cast<double>(hole) / loops.size(), FillingStage);
    const std::size_t faces = surface.mesh().number_of_faces();
    const std::size_t vertices = surface.mesh().number_of_vertices();
    const int vertex = loops[hole].front();
    const auto border = CGAL::is_border(Vertex(vertex), surface.mesh());
    if (!border)
    {
      throw InvalidInput("vertex " + std::to_string(vertex) + " is not on the boundary");
    }
    fillHole(surface, *border, kind);
    patches[hole] = lastPatch(surface, faces, vertices, mesh.vertexCount());
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

// The surface with the patches, one after the other.
PatchedSurface patched(const TriangleMesh& mesh, const std::vector<HolePatch>& patches)
{
  PatchedSurface result;
  result.Surface.Mesh = mesh;
  Points3& points = result.Surface.Mesh.Vertices;
  FaceMatrix& corners = result.Surface.Mesh.Faces;
  std::vector<int>& origins = result.Surface.Faces;
  std::vector<Origin> vertices;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    vertices.push_back({ { v, 1.0 } });
  }
  origins.resize(mesh.faceCount());
  std::iota(origins.begin(), origins.end(), 0);
  std::size_t faceCount = origins.size();
  std::size_t vertexCount = vertices.size();
  for (const HolePatch& patch : patches)
  {
    faceCount += patch.Faces.size();
    vertexCount += patch.Vertices.size();
  }
  corners.conservativeResize(static_cast<Eigen::Index>(faceCount), 3);
  points.conservativeResize(static_cast<Eigen::Index>(vertexCount), 3);
  for (const HolePatch& patch : patches)
  {
    const int shift = static_cast<int>(vertices.size()) - mesh.vertexCount();
    std::vector<int>& faces = result.Patches.emplace_back();
    for (const Triangle& face : patch.Faces)
    {
      const auto f = static_cast<int>(origins.size());
      for (int k = 0; k < 3; ++k)
      {
        corners(f, k) = face[k] < mesh.vertexCount() ? face[k] : face[k] + shift;
      }
      faces.push_back(f);
      origins.push_back(-1);
    }
    for (std::size_t i = 0; i < patch.Vertices.size(); ++i)
    {
      points.row(static_cast<Eigen::Index>(vertices.size())) = patch.Vertices[i];
      vertices.push_back(patch.Origins[i]);
    }
  }
  result.Surface.Vertices = originMatrix(
    vertices, mesh.vertexCount(), [](const Origin& origin) -> const Origin& { return origin; });
  return result;
}

// The error message says where a loop that is too long lies.
void requireShort(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  double limit,
  const std::string& remedy)
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
            << length << " long, more than the limit of " << limit << ": " << remedy
            << "raise Fill Length Limit, or cut off with Clip what leaves the scan";
    throw InvalidInput(message.str());
  }
}

} // namespace

FilledSurface fillHoles(const TriangleMesh& mesh,
  const std::vector<std::vector<int>>& loops,
  double longestLoop,
  const ProgressCallback& progress,
  const std::string& remedy)
{
  for (const std::vector<int>& loop : loops)
  {
    requireShort(mesh, loop, longestLoop, remedy);
  }
  const int holes = static_cast<int>(loops.size());
  std::vector<HolePatch> patches(holes);
  const std::vector<char> all(holes, 1);
  makePatches(mesh, loops, all, Patch::Refined, patches, subrange(progress, 0.0, 0.4));
  PatchedSurface filled = patched(mesh, patches);
  std::vector<int> fewest = filled.intersections();

  const auto intersects = [](int count) { return count > 0; };
  double done = 0.4;
  for (const Patch kind : { Patch::Delaunay, Patch::LeastAngle, Patch::Fan })
  {
    if (std::none_of(fewest.begin(), fewest.end(), intersects))
    {
      break;
    }
    std::vector<char> chosen(holes);
    std::transform(fewest.begin(), fewest.end(), chosen.begin(), intersects);
    std::vector<HolePatch> tried = patches;
    makePatches(mesh, loops, chosen, kind, tried, subrange(progress, done, done + 0.2));
    done += 0.2;
    const std::vector<int> counts = patched(mesh, tried).intersections();
    for (int hole = 0; hole < holes; ++hole)
    {
      if (counts[hole] < fewest[hole])
      {
        patches[hole] = std::move(tried[hole]);
      }
    }
    filled = patched(mesh, patches);
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
