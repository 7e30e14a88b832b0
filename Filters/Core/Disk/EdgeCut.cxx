// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/EdgeCut.h"

#include "Base/EigenVersions.h"
#include "Base/Errors.h"
#include "Mesh/DisjointSets.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>

namespace flattening
{
namespace
{

// A corner of a face and one of the two edges between which it lies.
struct CornerSide
{
  int Vertex;
  int Other;  // the other end of the edge
  int Corner; // 3 face + position

  bool sameEdge(const CornerSide& side) const
  {
    return this->Vertex == side.Vertex && this->Other == side.Other;
  }
  bool operator<(const CornerSide& side) const
  {
    return std::tie(this->Vertex, this->Other, this->Corner) <
           std::tie(side.Vertex, side.Other, side.Corner);
  }
};

// Both directions of every edge of the seam, sorted.
std::vector<MeshEdge> directedEdges(const std::vector<MeshEdge>& seam, int vertexCount)
{
  std::vector<MeshEdge> directed;
  directed.reserve(2 * seam.size());
  for (const MeshEdge& edge : seam)
  {
    for (const int v : edge)
    {
      if (v < 0 || v >= vertexCount)
      {
        throw InvalidInput("the seam names vertex " + std::to_string(v) + ", but there are " +
                           std::to_string(vertexCount) + " vertices");
      }
    }
    directed.push_back(edge);
    directed.push_back({ edge[1], edge[0] });
  }
  std::sort(directed.begin(), directed.end());
  directed.erase(std::unique(directed.begin(), directed.end()), directed.end());
  return directed;
}

std::vector<CornerSide> cornersAtSeam(const FaceMatrix& faces, const std::vector<char>& onSeam)
{
  std::vector<CornerSide> sides;
  for (int f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = faces(f, k);
      if (onSeam[v])
      {
        sides.push_back({ v, faces(f, (k + 1) % 3), 3 * f + k });
        sides.push_back({ v, faces(f, (k + 2) % 3), 3 * f + k });
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

void requireEdges(const std::vector<MeshEdge>& directed, const std::vector<CornerSide>& sides)
{
  for (const MeshEdge& edge : directed)
  {
    const auto side = std::lower_bound(sides.begin(), sides.end(), CornerSide{ edge[0], edge[1], 0 });
    if (side == sides.end() || !side->sameEdge({ edge[0], edge[1], 0 }))
    {
      throw InvalidInput("the seam runs from vertex " + std::to_string(edge[0]) + " to vertex " +
                         std::to_string(edge[1]) + ", which no edge of the surface joins");
    }
  }
}

using Sectors = DisjointSets;

// Joins the corners of faces (3 face + position) into sectors: corners on either side of an edge that is
// not cut share their vertex.
Sectors sectorsOf(const std::vector<MeshEdge>& directed,
  const std::vector<CornerSide>& sides,
  std::size_t cornerCount)
{
  Sectors sectors(cornerCount);
  for (std::size_t s = 0; s + 1 < sides.size(); ++s)
  {
    const MeshEdge edge{ sides[s].Vertex, sides[s].Other };
    if (sides[s].sameEdge(sides[s + 1]) && !std::binary_search(directed.begin(), directed.end(), edge))
    {
      sectors.join(sides[s].Corner, sides[s + 1].Corner);
    }
  }
  return sectors;
}

// Gives every sector a vertex: the first sector of a vertex keeps it, the others get copies. Returns the
// original vertex of each vertex.
std::vector<int> separateSectors(FaceMatrix& faces, const std::vector<char>& onSeam, Sectors& sectors)
{
  std::vector<int> original(onSeam.size());
  std::iota(original.begin(), original.end(), 0);
  std::vector<int> vertexOfSector(faces.size(), -1);
  std::vector<char> taken(onSeam.size(), 0);
  for (int f = 0; f < faces.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = faces(f, k);
      if (!onSeam[v])
      {
        continue;
      }
      int& vertex = vertexOfSector[sectors.find(3 * f + k)];
      if (vertex < 0)
      {
        vertex = taken[v] ? static_cast<int>(original.size()) : v;
        if (taken[v])
        {
          original.push_back(v);
        }
        taken[v] = 1;
      }
      faces(f, k) = vertex;
    }
  }
  return original;
}

} // namespace

CutSurface cutAlongEdges(const TriangleMesh& mesh, const std::vector<MeshEdge>& seam)
{
  const std::vector<MeshEdge> directed = directedEdges(seam, mesh.vertexCount());
  CutSurface cut;
  cut.OnSeam.assign(mesh.vertexCount(), 0);
  for (const MeshEdge& edge : directed)
  {
    cut.OnSeam[edge[0]] = 1;
  }
  const std::vector<CornerSide> sides = cornersAtSeam(mesh.Faces, cut.OnSeam);
  requireEdges(directed, sides);

  Sectors sectors = sectorsOf(directed, sides, mesh.Faces.size());
  TriangleMesh& opened = cut.Surface.Mesh;
  opened.Faces = mesh.Faces;
  const std::vector<int> original = separateSectors(opened.Faces, cut.OnSeam, sectors);
  opened.Vertices = mesh.Vertices(original, flattening::all);
  cut.OnSeam.resize(original.size(), 1);
  cut.Surface.Vertices = keptVertices(original, mesh.vertexCount());
  cut.Surface.Faces.resize(mesh.faceCount());
  std::iota(cut.Surface.Faces.begin(), cut.Surface.Faces.end(), 0);
  return cut;
}

} // namespace flattening
