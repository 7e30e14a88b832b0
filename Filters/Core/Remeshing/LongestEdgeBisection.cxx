// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/LongestEdgeBisection.h"

#include "Base/Errors.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <sstream>

namespace flattening
{
namespace
{

using Halfedge = EditableSurface::Halfedge;
using Face = EditableSurface::Face;

// How much a squared length may exceed its limit: an edge as long as the limit is then kept at any scale
// of the mesh. A guard against rounding (1e-16), so that any value between that and a visible length
// works.
constexpr double LengthRounding = 1e-6;

// A strict order of the edges, without which the propagation could run in circles. Lengths are compared
// in single precision, so that edges equal up to rounding tie, and the same mesh at another scale is
// split alike.
bool isLonger(const EditableSurface& surface, Halfedge a, Halfedge b)
{
  const auto lengthA = static_cast<float>(surface.squaredLength(a));
  const auto lengthB = static_cast<float>(surface.squaredLength(b));
  return lengthA != lengthB ? lengthA > lengthB : surface.mesh().edge(a) < surface.mesh().edge(b);
}

Halfedge longestSide(const EditableSurface& surface, Face face)
{
  const SurfaceMesh& mesh = surface.mesh();
  const Halfedge a = mesh.halfedge(face);
  const Halfedge b = mesh.next(a);
  const Halfedge c = mesh.next(b);
  const Halfedge ab = isLonger(surface, a, b) ? a : b;
  return isLonger(surface, ab, c) ? ab : c;
}

// The edge at the end of the path over ever longer edges: it is the longest edge of both its faces.
Halfedge endOfPropagation(const EditableSurface& surface, Halfedge side)
{
  const SurfaceMesh& mesh = surface.mesh();
  while (!mesh.is_border(mesh.opposite(side)))
  {
    const Halfedge longer = longestSide(surface, mesh.face(mesh.opposite(side)));
    if (mesh.edge(longer) == mesh.edge(side))
    {
      break;
    }
    side = longer;
  }
  return side;
}

double squaredLimit(double longestEdge)
{
  return (1.0 + LengthRounding) * longestEdge * longestEdge;
}

// The middle of an edge lies strictly between its ends as long as edges are longer than the distance of
// neighbouring doubles, and so every bisection halves an edge: bisection comes to an end.
void requireResolvable(const EditableSurface& surface,
  const std::vector<Face>& faces,
  double longestEdge)
{
  const SurfaceMesh& mesh = surface.mesh();
  double largest = 0.0;
  for (const Face f : faces)
  {
    for (const SurfaceMesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
    {
      const auto& p = mesh.point(v);
      largest = std::max({ largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z()) });
    }
  }
  if (faces.empty())
  {
    return;
  }
  if (!(longestEdge > ShortestBisected * largest))
  {
    std::ostringstream message;
    message << "edges cannot be bisected down to the length " << longestEdge
            << " at coordinates as large as " << largest << ": move the surface to the origin";
    throw InvalidInput(message.str());
  }
}

// Bisects the faces as bisectLongEdges does. Returns false, with some of them bisected, if that makes
// more than a number of faces.
bool bisect(EditableSurface& surface,
  const std::vector<Face>& faces,
  double longestEdge,
  std::size_t mostFaces)
{
  SurfaceMesh& mesh = surface.mesh();
  requireResolvable(surface, faces, longestEdge);
  std::vector<char> wanted(mesh.num_faces(), 0);
  for (const Face f : faces)
  {
    wanted[f] = 1;
  }
  const double limit = squaredLimit(longestEdge);
  std::deque<Face> queue(faces.begin(), faces.end());
  while (!queue.empty())
  {
    const Face face = queue.front();
    const Halfedge side = longestSide(surface, face);
    if (surface.squaredLength(side) <= limit)
    {
      queue.pop_front();
      continue;
    }
    if (mesh.num_faces() >= mostFaces)
    {
      return false;
    }
    const auto split = surface.splitEdge(endOfPropagation(surface, side), 0.5);
    wanted.resize(mesh.num_faces(), 0);
    for (const auto& [half, rest] : split.Halves)
    {
      if (wanted[half])
      {
        wanted[rest] = 1;
        queue.push_back(rest);
      }
    }
  }
  return true;
}

// The half-edges along a boundary loop that belong to faces.
std::vector<Halfedge> innerSides(const SurfaceMesh& mesh, const std::vector<int>& loop)
{
  std::vector<Halfedge> sides;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const SurfaceMesh::Vertex_index from(loop[i]);
    const SurfaceMesh::Vertex_index to(loop[(i + 1) % loop.size()]);
    sides.push_back(mesh.halfedge(from, to));
  }
  return sides;
}

std::vector<Face> facesAt(const SurfaceMesh& mesh, const std::vector<Halfedge>& sides)
{
  std::vector<Face> faces;
  for (const Halfedge side : sides)
  {
    faces.push_back(mesh.face(side));
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

// Halves each of the edges until no part is longer than a limit: less than twice as many parts as the
// limit fits into the edge, and one.
void halveEdges(EditableSurface& surface, std::vector<Halfedge> edges, double longestEdge)
{
  while (!edges.empty())
  {
    const Halfedge edge = edges.back(); // after a split the second half of the edge
    if (surface.squaredLength(edge) <= squaredLimit(longestEdge))
    {
      edges.pop_back();
      continue;
    }
    const EditableSurface::Vertex source = surface.mesh().source(edge);
    const EditableSurface::Vertex middle = surface.splitEdge(edge, 0.5).Middle;
    edges.push_back(surface.mesh().halfedge(source, middle));
  }
}

} // namespace

void bisectLongEdges(EditableSurface& surface, const std::vector<Face>& faces, double longestEdge)
{
  bisect(surface, faces, longestEdge, std::numeric_limits<std::size_t>::max());
}

double halveLongEdges(EditableSurface& surface, const std::vector<Face>& faces, double wanted)
{
  double longest = 0.0;
  for (const Face face : faces)
  {
    longest = std::max(longest, surface.longestEdge(face));
  }
  longest = std::max(wanted, 0.5 * longest);
  bisectLongEdges(surface, faces, longest);
  return longest;
}

DerivedMesh refineBoundary(const TriangleMesh& mesh, int minimumVertices)
{
  const MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
  const std::vector<std::vector<int>>& loops = topology.BoundaryLoops;
  const auto longest = std::max_element(loops.begin(),
    loops.end(),
    [&mesh](const auto& a, const auto& b)
    { return loopLength(mesh.Vertices, a) < loopLength(mesh.Vertices, b); });
  if (longest == loops.end() || static_cast<int>(longest->size()) >= minimumVertices)
  {
    return derivedFromItself(mesh);
  }

  // A disk in the plane has 0.18 n^2 equilateral triangles with n of them along its boundary, and
  // bisection makes up to four times as many. More come from faces that reach far from the boundary: on
  // a tube that is closed at one end, of 42 faces as long as the tube, 95,000 for 64 vertices.
  const std::size_t mostNewFaces = static_cast<std::size_t>(minimumVertices) * minimumVertices;
  // Edges no longer than the mean edge of a boundary with just `minimumVertices` vertices.
  const double edge = loopLength(mesh.Vertices, *longest) / minimumVertices;
  EditableSurface surface(mesh);
  const std::vector<Halfedge> sides = innerSides(surface.mesh(), *longest);
  if (bisect(surface, facesAt(surface.mesh(), sides), edge, mesh.faceCount() + mostNewFaces))
  {
    return surface.derived();
  }
  EditableSurface again(mesh); // has the same half-edges as the first had
  halveEdges(again, sides, edge);
  return again.derived();
}

} // namespace flattening
