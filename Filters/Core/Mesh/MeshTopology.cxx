// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshTopology.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>

namespace flattening
{
namespace
{

// One side of a face, keyed by its undirected edge.
struct Side
{
  std::uint64_t Edge;
  int From;
  int To;
  int Face;
};

std::vector<Side> sortedSides(const FaceMatrix& faces, int vertexCount)
{
  // Sides are put with the smaller of their vertices first; few are left to be sorted there.
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

struct DisjointSets
{
  std::vector<int> Parent;

  explicit DisjointSets(int n)
    : Parent(n)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }
  int find(int i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }
  void join(int i, int j) { this->Parent[this->find(i)] = this->find(j); }
};

// Every vertex must have one umbrella of faces: as many fans as vertices in use.
void requireOneFanPerVertex(const FaceMatrix& faces, const std::vector<Side>& sides, int vertexCount)
{
  const auto corner = [&faces](int face, int vertex) {
    return 3 * face + (faces(face, 0) == vertex ? 0 : faces(face, 1) == vertex ? 1 : 2);
  };
  DisjointSets corners(static_cast<int>(3 * faces.rows()));
  for (std::size_t s = 0; s + 1 < sides.size(); ++s)
  {
    const Side& a = sides[s];
    const Side& b = sides[s + 1];
    if (a.Edge == b.Edge)
    {
      corners.join(corner(a.Face, a.From), corner(b.Face, a.From));
      corners.join(corner(a.Face, a.To), corner(b.Face, a.To));
    }
  }
  std::vector<int> fan(vertexCount, -1);
  for (int f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = faces(f, k);
      const int root = corners.find(3 * f + k);
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

} // namespace

MeshTopology analyseTopology(const FaceMatrix& faces, int vertexCount)
{
  const std::vector<Side> sides = sortedSides(faces, vertexCount);

  MeshTopology topology;
  topology.Faces = static_cast<int>(faces.rows());
  std::vector<int> next(vertexCount, -1);
  DisjointSets parts(vertexCount);
  std::vector<char> used(vertexCount, 0);
  for (std::size_t s = 0; s < sides.size();)
  {
    std::size_t end = s + 1;
    while (end < sides.size() && sides[end].Edge == sides[s].Edge)
    {
      ++end;
    }
    ++topology.Edges;
    const Side& side = sides[s];
    used[side.From] = used[side.To] = 1;
    parts.join(side.From, side.To);
    if (end - s > 2)
    {
      throw TopologyError(edgeName(side) + " is non-manifold: " + std::to_string(end - s) +
                          " faces share it: run Surface To Disk first");
    }
    if (end - s == 2)
    {
      if (side.From == sides[s + 1].From)
      {
        throw TopologyError("faces " + std::to_string(side.Face) + " and " +
                            std::to_string(sides[s + 1].Face) + " at " + edgeName(side) +
                            " are oriented against each other: run Surface To Disk first");
      }
    }
    s = end;
  }
  requireOneFanPerVertex(faces, sides, vertexCount);

  // With one fan per vertex each boundary vertex has exactly one outgoing boundary side.
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    const bool shared = (s > 0 && sides[s - 1].Edge == sides[s].Edge) ||
                        (s + 1 < sides.size() && sides[s + 1].Edge == sides[s].Edge);
    if (!shared)
    {
      next[sides[s].From] = sides[s].To;
    }
  }
  std::vector<char> visited(vertexCount, 0);
  for (int v = 0; v < vertexCount; ++v)
  {
    topology.Vertices += used[v];
    if (used[v] && parts.find(v) == v)
    {
      ++topology.Components;
    }
    if (next[v] >= 0 && !visited[v])
    {
      std::vector<int> loop;
      for (int w = v; !visited[w]; w = next[w])
      {
        visited[w] = 1;
        loop.push_back(w);
      }
      topology.BoundaryLoops.push_back(std::move(loop));
    }
  }
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
