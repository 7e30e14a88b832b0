// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/FaceNeighbourhoods.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <unordered_set>
#include <utility>

namespace flattening
{

using Vertex = SurfaceMesh::Vertex_index;
using Halfedge = SurfaceMesh::Halfedge_index;
using Face = SurfaceMesh::Face_index;

double squaredDistance(const SurfaceMesh& mesh, Face face, const Kernel::Point_3& point)
{
  const Halfedge h = mesh.halfedge(face);
  return CGAL::squared_distance(point,
    Kernel::Triangle_3(
      mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))));
}

Face partAt(const EditableSurface& surface, int originalFace, const Kernel::Point_3& point)
{
  const SurfaceMesh& mesh = surface.mesh();
  // The part that kept the number; the others are connected to it.
  std::vector<Face> parts{ Face(static_cast<SurfaceMesh::size_type>(originalFace)) };
  std::unordered_set<std::size_t> found{ parts.front().idx() };
  std::pair<double, Face> nearest(HUGE_VAL, SurfaceMesh::null_face());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    nearest = std::min(nearest, { squaredDistance(mesh, parts[i], point), parts[i] });
    for (const Face next : mesh.faces_around_face(mesh.halfedge(parts[i])))
    {
      if (next != SurfaceMesh::null_face() && surface.origin(next) == originalFace &&
          found.insert(next.idx()).second)
      {
        parts.push_back(next);
      }
    }
  }
  return nearest.second;
}

std::vector<Face> facesInBall(const SurfaceMesh& mesh,
  Face start,
  const Kernel::Point_3& centre,
  double radius)
{
  std::vector<Face> faces{ start };
  std::vector<char> visited(mesh.num_faces(), 0);
  visited[start] = 1;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (const Face next : mesh.faces_around_face(mesh.halfedge(faces[i])))
    {
      if (next != SurfaceMesh::null_face() && !visited[next] &&
          squaredDistance(mesh, next, centre) < radius * radius)
      {
        visited[next] = 1;
        faces.push_back(next);
      }
    }
  }
  return faces;
}

std::vector<Face> facesNearestTo(const EditableSurface& surface, Vertex centre, double area)
{
  const SurfaceMesh& mesh = surface.mesh();
  using Entry = std::pair<double, Vertex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<double> distance(mesh.num_vertices(), HUGE_VAL);
  std::vector<char> taken(mesh.num_faces(), 0);
  std::vector<Face> faces;
  double sum = 0.0;
  distance[centre] = 0.0;
  queue.emplace(0.0, centre);
  while (!queue.empty() && sum < area)
  {
    const auto [soFar, v] = queue.top();
    queue.pop();
    if (soFar > distance[v])
    {
      continue;
    }
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      const Face face = mesh.face(h);
      if (face != SurfaceMesh::null_face() && !taken[face])
      {
        taken[face] = 1;
        faces.push_back(face);
        sum += surface.area(face);
      }
      const Vertex next = mesh.source(h);
      const double length = soFar + std::sqrt(surface.squaredLength(h));
      if (length < distance[next])
      {
        distance[next] = length;
        queue.emplace(length, next);
      }
    }
  }
  return faces;
}

} // namespace flattening
