// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/FaceFlags.h"

#include "Mesh/VertexFaces.h"

#include <algorithm>

namespace flattening
{
namespace
{

// The number of open fans that the faces with the flag form around the vertex. A fan begins at an edge
// with such a face on one side only.
int openFansAround(const TriangleMesh& mesh,
  const VertexFaces& around,
  int v,
  const std::vector<char>& flags,
  bool value)
{
  std::vector<int> next;     // of each face: the vertex after v
  std::vector<int> previous; // and the one before
  for (const int f : around[v])
  {
    const auto face = mesh.Faces.row(f);
    const int k = face[0] == v ? 0 : face[1] == v ? 1 : 2;
    if ((flags[f] != 0) == value)
    {
      next.push_back(face[(k + 1) % 3]);
      previous.push_back(face[(k + 2) % 3]);
    }
  }
  return static_cast<int>(std::count_if(next.begin(),
    next.end(),
    [&previous](int w) { return std::find(previous.begin(), previous.end(), w) == previous.end(); }));
}

} // namespace

std::vector<int> flagged(const std::vector<char>& flags, bool value)
{
  std::vector<int> numbers;
  for (std::size_t i = 0; i < flags.size(); ++i)
  {
    if ((flags[i] != 0) == value)
    {
      numbers.push_back(static_cast<int>(i));
    }
  }
  return numbers;
}

void flagAroundPinches(const TriangleMesh& mesh, std::vector<char>& flags, bool value)
{
  const VertexFaces around(mesh.Faces, mesh.vertexCount());
  for (bool changed = true; changed;) // ends: each turn either sets a flag or is the last
  {
    changed = false;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (openFansAround(mesh, around, v, flags, value) > 1)
      {
        for (const int f : around[v])
        {
          flags[f] = 1;
        }
        changed = true;
      }
    }
  }
}

} // namespace flattening
