// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/BoundaryEars.h"

#include <vector>

namespace flattening
{
namespace
{

using EarEdge = MeshOnSurface::Halfedge;

// How many edges of its face are on the boundary, beside the half-edge itself.
int otherBoundaryEdges(const MeshOnSurface::Mesh& mesh, EarEdge h)
{
  int edges = 0;
  for (const EarEdge other : { mesh.next(h), mesh.prev(h) })
  {
    edges += mesh.is_border(mesh.edge(other)) ? 1 : 0;
  }
  return edges;
}

bool isThirdEdgeOfEar(const MeshOnSurface::Mesh& mesh, EarEdge h)
{
  return !mesh.is_border(mesh.edge(h)) && otherBoundaryEdges(mesh, h) == 2;
}

} // namespace

void openEars(MeshOnSurface& surface,
  const MeshOnSurface::Guard& mayFlip,
  const MeshOnSurface::Guard& mayMove)
{
  const MeshOnSurface::Mesh& mesh = surface.mesh();
  std::vector<EarEdge> edges;
  for (const EarEdge h : mesh.halfedges())
  {
    if (isThirdEdgeOfEar(mesh, h))
    {
      edges.push_back(h);
    }
  }
  for (const EarEdge h : edges)
  {
    if (!isThirdEdgeOfEar(mesh, h)) // it was that of two ears
    {
      continue;
    }
    const bool flipMakesAnEar = otherBoundaryEdges(mesh, mesh.opposite(h)) > 0;
    if (flipMakesAnEar || !surface.flip(mesh.edge(h), mayFlip))
    {
      surface.split(mesh.edge(h), mayMove);
    }
  }
}

} // namespace flattening
