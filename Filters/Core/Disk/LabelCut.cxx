// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/LabelCut.h"

#include "Base/Errors.h"
#include "Mesh/FaceFlags.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceComponents.h"

#include <algorithm>
#include <string>

namespace flattening
{
namespace
{

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

} // namespace

LabelCutSurface cutLabel(const TriangleMesh& mesh, const std::vector<char>& labelled)
{
  std::vector<char> removed = labelled;
  const std::vector<int> chosen = flagged(removed);
  if (chosen.empty())
  {
    throw InvalidInput(
      "no face has the label: choose the array of labels, and a label that it has on the "
      "component that is kept");
  }
  requirePiece(mesh, chosen, "the label is");
  flagAroundPinches(mesh, removed, false);
  const std::vector<int> rest = flagged(removed, false);
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
  for (const int f : flagged(removed))
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
