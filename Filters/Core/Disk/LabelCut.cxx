// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/LabelCut.h"

#include "Base/Errors.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceComponents.h"
#include "Mesh/VertexFaces.h"

#include <algorithm>
#include <string>

namespace flattening
{
namespace
{

std::vector<int> facesWhere(const std::vector<char>& labelled, bool value)
{
  std::vector<int> faces;
  for (std::size_t f = 0; f < labelled.size(); ++f)
  {
    if ((labelled[f] != 0) == value)
    {
      faces.push_back(static_cast<int>(f));
    }
  }
  return faces;
}

void requirePiece(const TriangleMesh& mesh, const std::vector<int>& faces, const std::string& what)
{
  const int count = connectedComponents(extractFaces(mesh, faces).Mesh).Count;
  if (count > 1)
  {
    throw TopologyError(what + " in " + std::to_string(count) +
                        " pieces, so that its border is no outline of one disk: label one piece without "
                        "holes, e.g. after Connectivity");
  }
}

// The number of open fans that the faces without a label form around the vertex. A fan begins at an edge
// with a face of the rest on one side only.
int fansAround(const TriangleMesh& mesh,
  const VertexFaces& around,
  int v,
  const std::vector<char>& labelled)
{
  std::vector<int> next;     // of each face of the rest: the vertex after v
  std::vector<int> previous; // and the one before
  for (const int f : around[v])
  {
    if (!labelled[f])
    {
      for (int k = 0; k < 3; ++k)
      {
        if (mesh.Faces(f, k) == v)
        {
          next.push_back(mesh.Faces(f, (k + 1) % 3));
          previous.push_back(mesh.Faces(f, (k + 2) % 3));
        }
      }
    }
  }
  return static_cast<int>(std::count_if(next.begin(),
    next.end(),
    [&previous](int w) { return std::find(previous.begin(), previous.end(), w) == previous.end(); }));
}

// Labels the faces around vertices at which parts of the rest hang together by the vertex alone. Each
// turn labels a face more, so that the loop ends.
void labelLooseFaces(const TriangleMesh& mesh, std::vector<char>& labelled)
{
  const VertexFaces around(mesh.Faces, mesh.vertexCount());
  for (bool changed = true; changed;)
  {
    changed = false;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (fansAround(mesh, around, v, labelled) > 1)
      {
        for (const int f : around[v])
        {
          labelled[f] = 1;
        }
        changed = true;
      }
    }
  }
}

} // namespace

LabelCutSurface cutLabel(const TriangleMesh& mesh, const std::vector<char>& labelled)
{
  std::vector<char> removed = labelled;
  const std::vector<int> chosen = facesWhere(removed, true);
  if (chosen.empty())
  {
    throw InvalidInput(
      "no face has the label: choose the array of labels, and a label that it has on the "
      "component that is kept");
  }
  requirePiece(mesh, chosen, "the label is");
  labelLooseFaces(mesh, removed);
  const std::vector<int> rest = facesWhere(removed, false);
  if (rest.empty())
  {
    throw TopologyError(
      "the label covers the whole surface, so that nothing would be left: choose another "
      "label");
  }
  requirePiece(mesh, rest, "without the label, the surface is");

  LabelCutSurface cut;
  cut.Surface = extractFaces(mesh, rest);
  const TriangleMesh& left = cut.Surface.Mesh;
  cut.RemovedArea =
    faceAreas(mesh.Vertices, mesh.Faces).sum() - faceAreas(left.Vertices, left.Faces).sum();
  std::vector<char> onBorder(mesh.vertexCount(), 0);
  for (const int f : facesWhere(removed, true))
  {
    for (const int v : mesh.Faces.row(f))
    {
      onBorder[v] = 1;
    }
  }
  int loops = 0;
  for (const std::vector<int>& loop : analyseTopology(left.Faces, left.vertexCount()).BoundaryLoops)
  {
    const auto isOnBorder = [&](int v)
    { return onBorder[VertexOrigins::InnerIterator(cut.Surface.Vertices, v).col()] != 0; };
    if (std::any_of(loop.begin(), loop.end(), isOnBorder))
    {
      ++loops;
      cut.Boundary = loop;
    }
  }
  if (loops != 1)
  {
    throw TopologyError("the border of the label consists of " + std::to_string(loops) +
                        " loops: label one piece without holes that does not reach around the surface");
  }
  return cut;
}

} // namespace flattening
