// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshTopology.h"

#include "Base/Errors.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>

namespace flattening
{
namespace
{

// A side of a face.
struct Side
{
  std::uint64_t Edge; // the same for all sides of an edge
  int From;
  int To;
  int Face;
};

// The sides of all faces, sorted by edge and then by face.
std::vector<Side> sortedSides(const FaceMatrix& faces, int vertexCount)
{
  // A counting sort by the smaller vertex of each side leaves few sides per vertex to be sorted.
  std::vector<std::size_t> begin(static_cast<std::size_t>(vertexCount) + 1, 0);
  for (int f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = faces(f, k);
      const int to = faces(f, (k + 1) % 3);
      if (from < 0 || from >= vertexCount)
      {
        throw InvalidInput("face " + std::to_string(f) + " names vertex " + std::to_string(from) +
                           ", but there are " + std::to_string(vertexCount) + " vertices");
      }
      if (from == to)
      {
        throw InvalidInput("face " + std::to_string(f) + " uses vertex " + std::to_string(from) +
                           " twice: run Surface To Disk first");
      }
      if (to >= 0 && to < vertexCount)
      {
        ++begin[std::min(from, to) + 1];
      }
    }
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Side> sides(3 * static_cast<std::size_t>(faces.rows()));
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (int f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = faces(f, k);
      const int to = faces(f, (k + 1) % 3);
      const auto key = (static_cast<std::uint64_t>(std::min(from, to)) << 32) |
                       static_cast<std::uint64_t>(std::max(from, to));
      sides[next[std::min(from, to)]++] = { key, from, to, f };
    }
  }
  for (int v = 0; v < vertexCount; ++v)
  {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin[v]),
      sides.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
      [](const Side& a, const Side& b) { return a.Edge != b.Edge ? a.Edge < b.Edge : a.Face < b.Face; });
  }
  return sides;
}

std::string edgeName(const Side& side)
{
  return "edge (" + std::to_string(side.From) + ", " + std::to_string(side.To) + ")";
}

// The corners of the faces around a vertex must be one fan, in which neighbours share an edge.
void requireOneFanPerVertex(const FaceMatrix& faces, const std::vector<Side>& sides, int vertexCount)
{
  const auto corner = [&faces](int face, int vertex) {
    return 3 * face + (faces(face, 0) == vertex ? 0 : faces(face, 1) == vertex ? 1 : 2);
  };
  boost::disjoint_sets_with_storage<> corners(3 * faces.rows());
  for (std::size_t s = 0; s + 1 < sides.size(); ++s)
  {
    const Side& a = sides[s];
    const Side& b = sides[s + 1];
    if (a.Edge == b.Edge)
    {
      corners.union_set(corner(a.Face, a.From), corner(b.Face, a.From));
      corners.union_set(corner(a.Face, a.To), corner(b.Face, a.To));
    }
  }
  std::vector<int> fan(vertexCount, -1);
  for (int f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = faces(f, k);
      const int root = corners.find_set(3 * f + k);
      if (fan[v] < 0)
      {
        fan[v] = root;
      }
      else if (fan[v] != root)
      {
        throw TopologyError(
          "vertex " + std::to_string(v) +
          " is non-manifold (parts of the surface meet only there): run Surface To Disk first");
      }
    }
  }
}

// @param count  number of sides of the edge, of which @p side is the first
void requireManifoldEdge(const Side* side, std::ptrdiff_t count)
{
  if (count > 2)
  {
    throw TopologyError(edgeName(*side) + " is non-manifold: " + std::to_string(count) +
                        " faces share it: run Surface To Disk first");
  }
  if (count == 2 && side[0].From == side[1].From)
  {
    throw TopologyError("faces " + std::to_string(side[0].Face) + " and " +
                        std::to_string(side[1].Face) + " at " + edgeName(*side) +
                        " are oriented against each other: run Surface To Disk first");
  }
}

// Counts the edges, which must be manifold, the vertices that have an edge, and the components.
void countParts(const std::vector<Side>& sides, int vertexCount, MeshTopology& topology)
{
  boost::disjoint_sets_with_storage<> parts(vertexCount);
  std::vector<char> used(vertexCount, 0);
  for (std::size_t s = 0; s < sides.size();)
  {
    const Side& side = sides[s];
    std::size_t end = s + 1;
    while (end < sides.size() && sides[end].Edge == side.Edge)
    {
      ++end;
    }
    requireManifoldEdge(&side, static_cast<std::ptrdiff_t>(end - s));
    ++topology.Edges;
    used[side.From] = used[side.To] = 1;
    parts.union_set(side.From, side.To);
    s = end;
  }
  for (int v = 0; v < vertexCount; ++v)
  {
    topology.Vertices += used[v];
    topology.Components += used[v] && parts.find_set(v) == v;
  }
}

// The loops, each from its smallest vertex on, in ascending order of these. Every vertex must have one
// fan of faces, so that it has at most one outgoing boundary side.
std::vector<std::vector<int>> boundaryLoops(const std::vector<Side>& sides, int vertexCount)
{
  std::vector<int> next(vertexCount, -1);
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    const bool shared = (s > 0 && sides[s - 1].Edge == sides[s].Edge) ||
                        (s + 1 < sides.size() && sides[s + 1].Edge == sides[s].Edge);
    if (!shared)
    {
      next[sides[s].From] = sides[s].To;
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
  const std::vector<Side> sides = sortedSides(faces, vertexCount);
  MeshTopology topology;
  topology.Faces = static_cast<int>(faces.rows());
  countParts(sides, vertexCount, topology);
  requireOneFanPerVertex(faces, sides, vertexCount);
  topology.BoundaryLoops = boundaryLoops(sides, vertexCount);
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
