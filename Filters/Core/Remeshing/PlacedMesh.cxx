// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/PlacedMesh.h"

#include "Base/Errors.h"

#include <string>

namespace flattening
{

PlacedMesh placedOnItself(const ClosestPointWalk& walk)
{
  const TriangleMesh& mesh = walk.mesh();
  PlacedMesh placed{ mesh, {} };
  placed.Places.reserve(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const int face = walk.faceOf(v);
    if (face < 0)
    {
      throw TopologyError(
        "vertex " + std::to_string(v) + " belongs to no face: run Surface To Disk first");
    }
    SurfacePoint place{ face, mesh.Vertices.row(v), { 0.0, 0.0, 0.0 } };
    for (int k = 0; k < 3; ++k)
    {
      place.Weights[k] = mesh.Faces(face, k) == v ? 1.0 : 0.0;
    }
    placed.Places.push_back(place);
  }
  return placed;
}

} // namespace flattening
