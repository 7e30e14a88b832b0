// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/BoundaryRefinement.h"

#include "Mesh/EditableSurface.h"
#include "Mesh/MeshMeasures.h"
#include "Mesh/MeshTopology.h"
#include "Remeshing/LongestEdgeBisection.h"

#include <algorithm>
#include <vector>

namespace flattening
{

DerivedMesh refineBoundary(const TriangleMesh& mesh, int minimumVertices)
{
  const MeshTopology topology = analyseTopology(mesh.Faces, mesh.vertexCount());
  const std::vector<std::vector<int>>& loops = topology.BoundaryLoops;
  const auto longest = std::max_element(loops.begin(),
    loops.end(),
    [&mesh](const auto& a, const auto& b)
    { return loopLength(mesh.Vertices, a) < loopLength(mesh.Vertices, b); });
  if (longest == loops.end() || static_cast<int>(longest->size()) >= minimumVertices)
  {
    return derivedFromItself(mesh);
  }

  EditableSurface surface(mesh);
  const SurfaceMesh& half = surface.mesh();
  std::vector<EditableSurface::Face> faces;
  for (std::size_t i = 0; i < longest->size(); ++i)
  {
    const SurfaceMesh::Vertex_index from((*longest)[i]);
    const SurfaceMesh::Vertex_index to((*longest)[(i + 1) % longest->size()]);
    faces.push_back(half.face(half.halfedge(from, to)));
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  // No edge longer than the mean one of a boundary with just as many.
  bisectLongEdges(surface, faces, loopLength(mesh.Vertices, *longest) / minimumVertices);
  return surface.derived();
}

} // namespace flattening
