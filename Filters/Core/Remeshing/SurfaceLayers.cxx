// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/SurfaceLayers.h"

#include "Mesh/VertexFaces.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
namespace
{

// Sets the levels of the vertices of a component by their distance, in edges, from one of them. Returns
// the vertex that is reached last.
int spread(const FaceMatrix& faces, const VertexFaces& around, int start, std::vector<int>& levels)
{
  std::vector<int> reached{ start };
  levels[start] = 0;
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    const int v = reached[i];
    for (const int f : around[v])
    {
      for (int k = 0; k < 3; ++k)
      {
        if (const int w = faces(f, k); levels[w] < 0)
        {
          levels[w] = levels[v] + 1;
          reached.push_back(w);
        }
      }
    }
  }
  return reached.back();
}

} // namespace

std::vector<int> levelsOfFaces(const TriangleMesh& mesh)
{
  const VertexFaces around(mesh.Faces, mesh.vertexCount());
  std::vector<int> fromFirst(mesh.vertexCount(), -1);
  std::vector<int> levels(mesh.vertexCount(), -1);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (fromFirst[v] < 0)
    {
      spread(mesh.Faces, around, spread(mesh.Faces, around, v, fromFirst), levels);
    }
  }
  std::vector<int> ofFaces(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f)
  {
    ofFaces[f] =
      std::min({ levels[mesh.Faces(f, 0)], levels[mesh.Faces(f, 1)], levels[mesh.Faces(f, 2)] });
  }
  return ofFaces;
}

std::vector<int> firstLevels(const std::vector<int>& levels, int layers)
{
  std::vector<long> facesBelow(*std::max_element(levels.begin(), levels.end()) + 2, 0);
  for (const int level : levels)
  {
    ++facesBelow[level + 1];
  }
  std::partial_sum(facesBelow.begin(), facesBelow.end(), facesBelow.begin());
  std::vector<int> first;
  for (int layer = 1; layer < layers; ++layer)
  {
    const long share = facesBelow.back() * layer / layers;
    first.push_back(static_cast<int>(
      std::lower_bound(facesBelow.begin(), facesBelow.end(), share) - facesBelow.begin()));
  }
  return first;
}

} // namespace flattening
