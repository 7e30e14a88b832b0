// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/LongestEdgeBisection.h"

#include <deque>

namespace flattening
{
namespace
{

using Halfedge = EditableSurface::Halfedge;
using Face = EditableSurface::Face;

// Of a squared length: an edge as long as the limit is not too long at any scale.
constexpr double Rounding = 1e-6;

// A strict order of the edges, or propagation could run in circles. Lengths are compared in single
// precision, so that edges equal up to rounding tie, and the same mesh at another scale is split alike.
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

// The edge at the end of the path over ever longer edges: the longest of both its faces.
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

} // namespace

void bisectLongEdges(EditableSurface& surface, const std::vector<Face>& faces, double longestEdge)
{
  SurfaceMesh& mesh = surface.mesh();
  std::vector<char> wanted(mesh.num_faces(), 0);
  for (const Face f : faces)
  {
    wanted[f] = 1;
  }
  const double limit = (1.0 + Rounding) * longestEdge * longestEdge;
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
}

} // namespace flattening
