// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshTopology.h"

#include "Base/Errors.h"
#include "Mesh/DisjointSets.h"
#include "Mesh/FaceSides.h"
#include "Mesh/Halfedges.h"

#include <algorithm>
#include <string>

namespace flattening
{
namespace
{

void requireVertices(const FaceMatrix& faces, int vertexCount)
{
  for (int f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = faces(f, k);
      if (v < 0 || v >= vertexCount)
      {
        throw InvalidInput("face " + std::to_string(f) + " names vertex " + std::to_string(v) +
                           ", but there are " + std::to_string(vertexCount) + " vertices");
      }
      if (v == faces(f, (k + 1) % 3))
      {
        throw InvalidInput("face " + std::to_string(f) + " uses vertex " + std::to_string(v) +
                           " twice: run Surface To Disk first");
      }
    }
  }
}

std::string edgeName(const FaceSide& side)
{
  return "edge (" + std::to_string(side.From) + ", " + std::to_string(side.To) + ")";
}

// The edges must be manifold.
void requireOneFanPerVertex(const FaceMatrix& faces, const std::vector<int>& opposite, int vertexCount)
{
  const std::vector<int> severalFans = verticesOfSeveralFans(faces, opposite, vertexCount);
  if (!severalFans.empty())
  {
    throw TopologyError(
      "vertex " + std::to_string(severalFans.front()) +
      " is non-manifold (parts of the surface meet only there): run Surface To Disk first");
  }
}

// @param count  number of sides of the edge, of which @p side is the first
void requireManifoldEdge(const FaceSide* side, int count)
{
  if (count > 2)
  {
    throw TopologyError(edgeName(*side) + " is non-manifold: " + std::to_string(count) +
                        " faces share it: run Surface To Disk first");
  }
  if (count == 2 && side[0].From == side[1].From)
  {
    throw TopologyError("faces " + std::to_string(side[0].face()) + " and " +
                        std::to_string(side[1].face()) + " at " + edgeName(*side) +
                        " are oriented against each other: run Surface To Disk first");
  }
}

// Counts the edges, which must be manifold, the vertices that have an edge, and the components.
void countParts(const std::vector<FaceSide>& sides, int vertexCount, MeshTopology& topology)
{
  DisjointSets parts(vertexCount);
  std::vector<char> used(vertexCount, 0);
  forEachEdge(sides,
    [&](const FaceSide* side, int count)
    {
      requireManifoldEdge(side, count);
      ++topology.Edges;
      used[side->From] = used[side->To] = 1;
      parts.join(side->From, side->To);
    });
  for (int v = 0; v < vertexCount; ++v)
  {
    topology.Vertices += used[v];
    topology.Components += used[v] && parts.find(v) == v;
  }
}

// The loops, each from its smallest vertex on, in ascending order of these. Every vertex must have one
// fan of faces, so that it has at most one outgoing boundary side.
std::vector<std::vector<int>> boundaryLoops(const FaceMatrix& faces,
  const std::vector<int>& opposite,
  int vertexCount)
{
  std::vector<int> next(vertexCount, -1);
  for (int h = 0; h < static_cast<int>(opposite.size()); ++h)
  {
    if (opposite[h] < 0)
    {
      next[faces.data()[h]] = faces.data()[nextHalfedge(h)];
    }
  }
  std::vector<std::vector<int>> loops;
  std::vector<char> visited(vertexCount, 0);
  for (int v = 0; v < vertexCount; ++v)
  {
    if (next[v] >= 0 && !visited[v])
    {
      std::vector<int>& loop = loops.emplace_back();
      for (int w = v; !visited[w]; w = next[w])
      {
        visited[w] = 1;
        loop.push_back(w);
      }
    }
  }
  return loops;
}

} // namespace

MeshTopology analyseTopology(const FaceMatrix& faces, int vertexCount)
{
  requireVertices(faces, vertexCount);
  const std::vector<FaceSide> sides = sortedSides(faces);
  MeshTopology topology;
  topology.Faces = static_cast<int>(faces.rows());
  countParts(sides, vertexCount, topology);
  const std::vector<int> opposite = oppositeHalfedges(sides);
  requireOneFanPerVertex(faces, opposite, vertexCount);
  topology.BoundaryLoops = boundaryLoops(faces, opposite, vertexCount);
  std::stable_sort(topology.BoundaryLoops.begin(),
    topology.BoundaryLoops.end(),
    [](const auto& a, const auto& b) { return a.size() > b.size(); });
  topology.Genus = (2 * topology.Components - static_cast<int>(topology.BoundaryLoops.size()) -
                     topology.eulerCharacteristic()) /
                   2;
  return topology;
}

std::vector<int> requireDisk(const TriangleMesh& mesh)
{
  if (mesh.faceCount() == 0)
  {
    throw InvalidInput("the surface has no triangles: pass a triangle surface, e.g. from Contour");
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (!mesh.Vertices.row(v).allFinite())
    {
      throw InvalidInput("vertex " + std::to_string(v) +
                         " has a coordinate that is not finite: clean the data before flattening");
    }
  }
  MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
  if (!(faceAreas(mesh.Vertices, mesh.Faces).sum() > 0.0))
  {
    throw InvalidInput("the surface has zero area: all of its triangles are degenerate");
  }
  if (topology.Vertices != mesh.vertexCount())
  {
    throw TopologyError(std::to_string(mesh.vertexCount() - topology.Vertices) +
                        " points belong to no triangle: run Surface To Disk first");
  }
  if (topology.Components > 1)
  {
    throw TopologyError("the surface has " + std::to_string(topology.Components) +
                        " components: run Surface To Disk first, or choose one with Connectivity");
  }
  if (topology.Genus > 0)
  {
    throw TopologyError(
      "the surface has genus " + std::to_string(topology.Genus) +
      ": run Surface To Disk first, which names the handles and what to do about them");
  }
  if (topology.BoundaryLoops.empty())
  {
    throw TopologyError("the surface is closed, a disk needs a boundary: run Surface To Disk first");
  }
  if (topology.BoundaryLoops.size() > 1)
  {
    throw TopologyError("the surface has " + std::to_string(topology.BoundaryLoops.size()) +
                        " boundary loops, a disk has one: run Surface To Disk first");
  }
  return topology.BoundaryLoops.front();
}

} // namespace flattening
