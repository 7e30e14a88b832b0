// SPDX-License-Identifier: GPL-3.0-or-later
/// Removes the handles and tunnels of a surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

#include <vector>

namespace flattening
{

struct HandleRemovalReport
{
  int Handles = 0;
  std::vector<double> LoopLengths;   ///< one per handle, input units
  double RemovedArea = 0.0;          ///< area that the faces beside the loops lost, input units squared
  double AddedArea = 0.0;            ///< area of the caps, input units squared
  double GreatestDisplacement = 0.0; ///< how far a vertex of the loops moved, input units; others stay
  int PiercingCaps = 0;              ///< cuts whose caps intersect other parts of the surface
  int NewIntersections = 0;          ///< pairs of faces that intersect there
};

struct SurfaceWithoutHandles
{
  DerivedMesh Surface;
  HandleRemovalReport Report;
};

/// Makes the genus 0: cuts each handle, or the tunnel through it, along a short loop of edges and closes
/// both sides by disks (caps). The shortest loops are cut first (cutHandles), because the noise of an
/// image makes handles with short loops. A loop is rejected for a longer one if its caps would intersect
/// another part of the surface.
///
/// The vertices of a loop move apart by a fraction of the edges around them. All other vertices and the
/// boundary loops stay. Caps have edges as long as those of the loop, but for cones (coneCap), which are
/// taken where they intersect fewer faces. Vertices and faces of @p mesh come
/// first, in their order; the faces of caps have origin -1, and their vertices the weights of the loop's
/// vertices.
/// @param mesh one component, oriented manifold, closed or with boundary.
/// @throws TopologyError if the mesh is not that, or a handle cannot be cut; Cancelled.
SurfaceWithoutHandles removeHandles(const TriangleMesh& mesh, const ProgressCallback& progress = {});

} // namespace flattening
