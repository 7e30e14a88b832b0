// SPDX-License-Identifier: GPL-3.0-or-later
#include "Handles/LoopCapping.h"

#include "Mesh/ClosestPointTree.h"
#include "Mesh/EditableSurface.h"

#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <utility>

namespace flattening
{
namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;

using Polyline = std::vector<Eigen::Vector3d>;
using Faces = std::vector<std::array<int, 3>>;

// Turns the faces over if they do not run along the loop.
void orientAlongLoop(Faces& faces, int n)
{
  const bool along = std::any_of(faces.begin(),
    faces.end(),
    [n](const auto& face)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (face[k] < n && face[(k + 1) % 3] == (face[k] + 1) % n)
        {
          return true;
        }
      }
      return false;
    });
  if (!along)
  {
    for (auto& face : faces)
    {
      std::swap(face[1], face[2]);
    }
  }
}

double perimeter(const Polyline& loop)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    sum += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  }
  return sum;
}

TriangleMesh meshOf(const Polyline& points, const Faces& faces)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    mesh.Vertices.row(static_cast<Eigen::Index>(v)) = points[v].transpose();
  }
  mesh.Faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      mesh.Faces(static_cast<Eigen::Index>(f), k) = faces[f][k];
    }
  }
  return mesh;
}

// Adds vertices to the density of the loop's.
void refine(SurfaceMesh& mesh)
{
  const std::vector<SurfaceMesh::Face_index> old(mesh.faces().begin(), mesh.faces().end());
  std::vector<SurfaceMesh::Face_index> newFaces;
  std::vector<SurfaceMesh::Vertex_index> newVertices;
  PMP::refine(mesh, old, std::back_inserter(newFaces), std::back_inserter(newVertices));
}

// Does so too where edges to an inner vertex let refine() take the disk for a sparse one.
void remesh(SurfaceMesh& mesh, const Polyline& loop)
{
  double longest = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    longest = std::max(longest, (loop[(i + 1) % loop.size()] - loop[i]).norm());
  }
  const double mean = perimeter(loop) / static_cast<double>(loop.size());
  // CGAL splits edges above 4/3 of the target. Were an edge of the loop, which stays, longer than that,
  // those beside it would be as well, and splitting would not end.
  constexpr double LongestOfLoop = 1.2;
  constexpr int Iterations = 3;
  PMP::isotropic_remeshing(mesh.faces(),
    std::max(mean, longest / LongestOfLoop),
    mesh,
    CGAL::parameters::number_of_iterations(Iterations).protect_constraints(true));
  mesh.collect_garbage();
}

// A disk with vertices of its own; `coarse` may have one beside the loop's already, the centre.
LoopCap capOf(const SurfaceMesh& mesh, const TriangleMesh& coarse, std::size_t loopSize)
{
  const TriangleMesh fine = toTriangleMesh(mesh);

  LoopCap cap;
  for (int f = 0; f < fine.faceCount(); ++f)
  {
    cap.Faces.push_back({ fine.Faces(f, 0), fine.Faces(f, 1), fine.Faces(f, 2) });
  }
  const auto n = static_cast<int>(loopSize);
  if (fine.vertexCount() == n)
  {
    return cap;
  }
  const ClosestPointTree projection(coarse);
  for (int v = n; v < fine.vertexCount(); ++v)
  {
    cap.Inside.push_back(fine.Vertices.row(v).transpose());
    const SurfacePoint at = projection.closest(cap.Inside.back());
    TracedSurface::Origin origin;
    double rest = 0.0; // of the centre, if there is one
    for (int k = 0; k < 3; ++k)
    {
      const int corner = coarse.Faces(at.Face, k);
      if (corner >= n)
      {
        rest = at.Weights[k] / n;
      }
      else if (at.Weights[k] > 0.0)
      {
        origin.emplace_back(corner, at.Weights[k]);
      }
    }
    if (rest > 0.0)
    {
      std::vector<double> weights(loopSize, rest);
      for (const auto& [corner, weight] : origin)
      {
        weights[corner] += weight;
      }
      origin.clear();
      for (int i = 0; i < n; ++i)
      {
        origin.emplace_back(i, weights[i]);
      }
    }
    cap.Weights.push_back(std::move(origin));
  }
  return cap;
}

// Calls visit(halfedge) for those that start at the origin of loop[i] on the loop's left; with the
// reversed loop, on its right.
template <typename Visit>
void visitLeft(const HalfedgeSurface& surface, int before, int after, const Visit& visit)
{
  int h = after;
  for (; HalfedgeSurface::previous(h) != before; h = surface.rotated(h))
  {
    visit(h);
  }
  visit(h);
}

// Among triangulations that are as good as each other, as for points of a grid or of a plane, CGAL's
// choice depends on where in memory it works. Moved by this share of a side, no two are.
std::vector<Kernel::Point_3> inGeneralPosition(const Polyline& loop)
{
  constexpr double Share = 1e-5;
  const double size = Share * perimeter(loop) / static_cast<double>(loop.size());
  std::mt19937 random;
  const auto shift = [&random, size]
  { return size * (static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 0.5); };
  std::vector<Kernel::Point_3> points;
  for (const Eigen::Vector3d& p : loop)
  {
    const double x = p.x() + shift();
    const double y = p.y() + shift();
    points.emplace_back(x, y, p.z() + shift());
  }
  return points;
}

} // namespace

LoopCap spanningCap(const Polyline& loop)
{
  std::vector<CGAL::Triple<int, int, int>> triples;
  PMP::triangulate_hole_polyline(inGeneralPosition(loop), std::back_inserter(triples));
  if (triples.empty())
  {
    return {};
  }
  Faces faces;
  for (const auto& t : triples)
  {
    faces.push_back({ t.first, t.second, t.third });
  }
  orientAlongLoop(faces, static_cast<int>(loop.size()));
  const TriangleMesh coarse = meshOf(loop, faces);
  SurfaceMesh mesh = toSurfaceMesh(coarse);
  refine(mesh);
  return capOf(mesh, coarse, loop.size());
}

LoopCap coneCap(const Polyline& loop)
{
  const auto n = static_cast<int>(loop.size());
  Polyline points = loop;
  points.emplace_back(Eigen::Vector3d::Zero());
  Faces faces;
  for (int i = 0; i < n; ++i)
  {
    points.back() += loop[i] / n;
    faces.push_back({ i, (i + 1) % n, n });
  }
  const TriangleMesh coarse = meshOf(points, faces);
  SurfaceMesh mesh = toSurfaceMesh(coarse);
  if (faceAreas(coarse.Vertices, coarse.Faces).minCoeff() > 0.0) // else CGAL's relaxation crashes
  {
    remesh(mesh, loop);
  }
  return capOf(mesh, coarse, loop.size());
}

void splitEdgesOf(const HalfedgeSurface& surface,
  const std::vector<int>& vertices,
  const Polyline& loop,
  LoopCap& cap)
{
  const auto n = static_cast<int>(vertices.size());
  for (std::size_t f = 0; f < cap.Faces.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = cap.Faces[f][k];
      const int b = cap.Faces[f][(k + 1) % 3];
      if (a >= n || b >= n || (a + 1) % n == b || (b + 1) % n == a ||
          surface.edgeBetween(vertices[a], vertices[b]) < 0)
      {
        continue;
      }
      const int middle = n + static_cast<int>(cap.Inside.size());
      cap.Inside.push_back(0.5 * (loop[a] + loop[b]));
      cap.Weights.push_back({ { a, 0.5 }, { b, 0.5 } });
      const std::size_t old = cap.Faces.size();
      for (std::size_t g = 0; g < old; ++g)
      {
        for (int j = 0; j < 3; ++j)
        {
          const int p = cap.Faces[g][j];
          const int q = cap.Faces[g][(j + 1) % 3];
          if ((p == a && q == b) || (p == b && q == a))
          {
            const int corner = cap.Faces[g][(j + 2) % 3];
            cap.Faces[g] = { p, middle, corner };
            cap.Faces.push_back({ middle, q, corner });
            break;
          }
        }
      }
      k = -1; // the face is another one now
    }
  }
}

CappedCut capBothSides(const HalfedgeSurface& surface,
  const std::vector<int>& loop,
  const LoopCap& cap,
  double step)
{
  const auto n = static_cast<int>(loop.size());
  const auto inside = static_cast<int>(cap.Inside.size());
  CappedCut result;
  result.Cap = cap;
  result.FirstCopy = surface.vertexCount();
  result.FirstRight = result.FirstCopy + n;
  result.FirstLeft = result.FirstRight + inside;
  std::map<int, Eigen::Vector3d>& places = result.Faces.Places;

  std::map<int, std::array<int, 3>> around;
  const auto faceAround = [&](int h) -> std::array<int, 3>&
  {
    const int f = HalfedgeSurface::face(h);
    return around
      .try_emplace(f,
        std::array<int, 3>{
          surface.origin(3 * f), surface.origin(3 * f + 1), surface.origin(3 * f + 2) })
      .first->second;
  };
  // The centre of the faces at a vertex of the loop on one side.
  const auto place = [&](int before, int after, int v, int number)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0.0;
    const Eigen::Vector3d& p = surface.point(v);
    visitLeft(surface,
      before,
      after,
      [&](int h)
      {
        const Eigen::Vector3d a = surface.point(surface.tip(h)) - p;
        const Eigen::Vector3d b = surface.point(surface.origin(HalfedgeSurface::previous(h))) - p;
        const double twice = a.cross(b).norm();
        sum += twice * (a + b) / 3.0;
        area += twice;
        faceAround(h)[h % 3] = number;
      });
    places[number] = area > 0.0 ? Eigen::Vector3d(p + step * sum / area) : p;
  };

  std::vector<Eigen::Vector3d> apart(n); // from the right copy to the left one
  double distance = 0.0;
  for (int i = 0; i < n; ++i)
  {
    const int v = surface.origin(loop[i]);
    const int before = loop[(i + n - 1) % n];
    result.Vertices.push_back(v);
    place(before, loop[i], v, result.FirstCopy + i);
    place(surface.twin(loop[i]), surface.twin(before), v, v);
    apart[i] = places[result.FirstCopy + i] - places[v];
    distance += apart[i].norm() / n;
  }

  // Inner vertices move along the cap's normal, to the side to which the loop's moved.
  const auto at = [&](int v) -> const Eigen::Vector3d&
  { return v < n ? surface.point(result.Vertices[v]) : cap.Inside[v - n]; };
  std::vector<Eigen::Vector3d> normals(n + inside, Eigen::Vector3d::Zero());
  for (const auto& face : cap.Faces)
  {
    const Eigen::Vector3d normal = (at(face[1]) - at(face[0])).cross(at(face[2]) - at(face[0]));
    for (const int v : face)
    {
      normals[v] += normal;
    }
  }
  double side = 0.0;
  for (int i = 0; i < n; ++i)
  {
    side += apart[i].dot(normals[i].stableNormalized());
  }
  const double offset = std::copysign(0.5 * distance, side);
  for (int j = 0; j < inside; ++j)
  {
    const Eigen::Vector3d shift = offset * normals[n + j].stableNormalized();
    places[result.FirstRight + j] = cap.Inside[j] - shift;
    places[result.FirstLeft + j] = cap.Inside[j] + shift;
  }

  for (const auto& [face, corners] : around)
  {
    result.Faces.Replaced.push_back(face);
    result.Faces.Faces.push_back(corners);
  }
  for (const auto& face : cap.Faces)
  {
    std::array<int, 3> right;
    for (int k = 0; k < 3; ++k)
    {
      right[k] = face[k] < n ? result.Vertices[face[k]] : result.FirstRight + face[k] - n;
    }
    result.Faces.Faces.push_back(right);
  }
  for (const auto& face : cap.Faces)
  {
    std::array<int, 3> left;
    for (int k = 0; k < 3; ++k)
    {
      left[2 - k] = face[k] < n ? result.FirstCopy + face[k] : result.FirstLeft + face[k] - n;
    }
    result.Faces.Faces.push_back(left);
  }
  return result;
}

} // namespace flattening
