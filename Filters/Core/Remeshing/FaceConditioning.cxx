// SPDX-License-Identifier: GPL-3.0-or-later
#include "Remeshing/FaceConditioning.h"

#include "Remeshing/MeshOnSurface.h"
#include "Remeshing/SelfIntersectionRemoval.h"
#include "Remeshing/SliverRemoval.h"

namespace flattening
{

DerivedMesh conditionFaces(const TriangleMesh& mesh, double degrees, const ProgressCallback& progress)
{
  MeshOnSurface surface(mesh);
  removeSlivers(surface, degrees, subrange(progress, 0.0, 0.5));
  removeSelfIntersections(surface, subrange(progress, 0.5, 1.0));
  return surface.derived();
}

} // namespace flattening
