// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/LongestEdgeBisection.h"

#include "Base/Errors.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <sstream>

namespace flattening
{
namespace
{

using Halfedge = EditableSurface::Halfedge;
using Face = EditableSurface::Face;
using Vertex = EditableSurface::Vertex;

// How much a squared length may exceed its limit: an edge as long as the limit is then kept at any scale
// of the mesh. A guard against rounding (1e-16), so that any value between that and a visible length
// works.
constexpr double LengthRounding = 1e-6;

// A number below 1e299 rounded to the 24 bits of single precision, but with the exponents of double
// precision (Dekker 1971, "A floating-point technique for extending the available precision").
double toSinglePrecision(double number)
{
  const double product = 0x20000001p0 * number; // 2^29 + 1
  return product - (product - number);
}

// A strict order of the edges, without which the propagation could run in circles. Lengths are compared
// in single precision, so that edges equal up to rounding tie, and the same mesh at another scale is
// split alike. Exponents are those of double precision: in single precision the squared lengths of all
// edges shorter than 1e-23 would tie, and parts of a face that is not split at its longest edge need not
// become shorter.
bool isLonger(const EditableSurface& surface, Halfedge a, Halfedge b)
{
  const double lengthA = toSinglePrecision(surface.squaredLength(a));
  const double lengthB = toSinglePrecision(surface.squaredLength(b));
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

// Splits the longest side of a face at its middle. The longer edges that a path from face to face leads
// to are split before, so that every split edge is the longest one of both its faces. The path goes on
// from where the last split left it: every step of it ends in one split, so that time grows with the
// number of new vertices.
template <typename OnSplit>
void splitWithLongerEdges(EditableSurface& surface, Halfedge side, const OnSplit& onSplit)
{
  const SurfaceMesh& mesh = surface.mesh();
  std::vector<Halfedge> path{ side };
  while (!path.empty())
  {
    const Halfedge last = path.back();
    const Halfedge opposite = mesh.opposite(last);
    const Halfedge longest =
      mesh.is_border(opposite) ? opposite : longestSide(surface, mesh.face(opposite));
    if (longest == opposite)
    {
      path.pop_back();
      onSplit(surface.splitEdge(last, 0.5));
    }
    else
    {
      path.push_back(longest);
    }
  }
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

// The faces with a vertex on the boundary loop of a border half-edge.
std::vector<Face> facesAround(const SurfaceMesh& mesh, Halfedge border)
{
  std::vector<Face> faces;
  for (const Halfedge along : mesh.halfedges_around_face(border))
  {
    for (const Face face : mesh.faces_around_target(along))
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

bool hasCorner(const SurfaceMesh& mesh, Face face, Vertex vertex)
{
  const auto corners = mesh.vertices_around_face(mesh.halfedge(face));
  return std::find(corners.begin(), corners.end(), vertex) != corners.end();
}

// Bisects each face around a vertex once if its squared longest edge exceeds the limit, and returns the
// number of these faces.
int bisectAround(EditableSurface& surface, Vertex vertex, double limit)
{
  const SurfaceMesh& mesh = surface.mesh();
  const auto around = mesh.faces_around_target(mesh.halfedge(vertex));
  const std::vector<Face> faces(around.begin(), around.end());
  int bisected = 0;
  for (const Face face : faces)
  {
    // When its neighbour was bisected, a face may have been, too; the part of it that keeps its index
    // need not touch the vertex.
    if (face == SurfaceMesh::null_face() || !hasCorner(mesh, face, vertex))
    {
      continue;
    }
    const Halfedge side = longestSide(surface, face);
    if (surface.squaredLength(side) > limit)
    {
      splitWithLongerEdges(surface, side, [](const EditableSurface::Split&) {});
      ++bisected;
    }
  }
  return bisected;
}

// Bisects the faces with a vertex on a boundary loop until none of them has an edge longer than a limit.
// The parts of a face that do not touch the loop stay as large as they are.
void bisectAlongBoundary(EditableSurface& surface, Halfedge border, double longestEdge)
{
  const double limit = squaredLimit(longestEdge);
  int bisected = 0;
  do // every bisection halves an edge longer than the limit
  {
    const auto along = surface.mesh().vertices_around_face(border);
    const std::vector<Vertex> loop(along.begin(), along.end());
    bisected = 0;
    for (const Vertex vertex : loop)
    {
      bisected += bisectAround(surface, vertex, limit);
    }
  } while (bisected > 0);
}

} // namespace

void bisectLongEdges(EditableSurface& surface, const std::vector<Face>& faces, double longestEdge)
{
  const SurfaceMesh& mesh = surface.mesh();
  requireResolvable(surface, faces, longestEdge);
  std::vector<char> wanted(mesh.num_faces(), 0);
  for (const Face f : faces)
  {
    wanted[f] = 1;
  }
  const double limit = squaredLimit(longestEdge);
  std::deque<Face> queue(faces.begin(), faces.end());
  const auto follow = [&](const EditableSurface::Split& split)
  {
    wanted.resize(mesh.num_faces(), 0);
    for (const auto& [half, rest] : split.Halves)
    {
      if (wanted[half])
      {
        wanted[rest] = 1;
        queue.push_back(rest);
      }
    }
  };
  while (!queue.empty())
  {
    const Face face = queue.front();
    const Halfedge side = longestSide(surface, face);
    if (surface.squaredLength(side) <= limit)
    {
      queue.pop_front();
      continue;
    }
    splitWithLongerEdges(surface, side, follow);
  }
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

  // Edges no longer than the mean edge of a boundary with just `minimumVertices` vertices.
  const double edge = loopLength(mesh.Vertices, *longest) / minimumVertices;
  EditableSurface surface(mesh);
  const Halfedge border = surface.mesh().opposite(surface.mesh().halfedge(
    SurfaceMesh::Vertex_index((*longest)[0]), SurfaceMesh::Vertex_index((*longest)[1])));
  requireResolvable(surface, facesAround(surface.mesh(), border), edge);
  bisectAlongBoundary(surface, border, edge);
  return surface.derived();
}

} // namespace flattening
