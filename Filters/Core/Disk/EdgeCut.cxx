// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/EdgeCut.h"

#include "Base/Errors.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>

namespace flattening
{
namespace
{

// A corner of a face and one of the two edges that it lies between.
struct CornerSide
{
  int Vertex;
  int Other;  // end of the edge
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

// The seam with both directions of every edge, sorted.
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

  // Corners on either side of an edge that is not cut share their vertex.
  boost::disjoint_sets_with_storage<> sectors(3 * static_cast<std::size_t>(mesh.faceCount()));
  for (std::size_t s = 0; s + 1 < sides.size(); ++s)
  {
    if (sides[s].sameEdge(sides[s + 1]) &&
        !std::binary_search(
          directed.begin(), directed.end(), MeshEdge{ sides[s].Vertex, sides[s].Other }))
    {
      sectors.union_set(sides[s].Corner, sides[s + 1].Corner);
    }
  }

  std::vector<int> original(mesh.vertexCount());
  std::iota(original.begin(), original.end(), 0);
  std::vector<int> vertexOfSector(3 * mesh.faceCount(), -1);
  std::vector<char> taken(mesh.vertexCount(), 0);
  TriangleMesh opened = mesh;
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = mesh.Faces(f, k);
      if (!cut.OnSeam[v])
      {
        continue;
      }
      int& vertex = vertexOfSector[sectors.find_set(3 * f + k)];
      if (vertex < 0)
      {
        vertex = taken[v] ? static_cast<int>(original.size()) : v;
        if (taken[v])
        {
          original.push_back(v);
        }
        taken[v] = 1;
      }
      opened.Faces(f, k) = vertex;
    }
  }

  opened.Vertices.conservativeResize(static_cast<Eigen::Index>(original.size()), 3);
  for (std::size_t v = mesh.vertexCount(); v < original.size(); ++v)
  {
    opened.Vertices.row(v) = mesh.Vertices.row(original[v]);
  }
  cut.OnSeam.resize(original.size(), 1);
  cut.Surface.Vertices = keptVertices(original, mesh.vertexCount());
  cut.Surface.Faces.resize(mesh.faceCount());
  std::iota(cut.Surface.Faces.begin(), cut.Surface.Faces.end(), 0);
  cut.Surface.Mesh = std::move(opened);
  return cut;
}

} // namespace flattening
