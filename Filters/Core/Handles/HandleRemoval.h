// SPDX-License-Identifier: GPL-3.0-or-later
/// Takes the handles and tunnels off a surface.
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
  double RemovedArea = 0.0;          ///< lost by the faces beside the loops, input units squared
  double AddedArea = 0.0;            ///< of the caps, input units squared
  double GreatestDisplacement = 0.0; ///< of a vertex of the loops, input units; others stay
  int PiercingCaps = 0;              ///< cuts whose caps meet other parts of the surface
  int NewIntersections = 0;          ///< pairs of faces that intersect there
};

struct SurfaceWithoutHandles
{
  DerivedMesh Surface;
  HandleRemovalReport Report;
};

/// Makes the genus 0: cuts each handle, or the tunnel through it, along a short loop of edges and closes
/// both sides by disks. Shortest loops first (HandleCutting), as noise of the image makes handles with
/// short loops. A loop is passed over for a longer one if its caps would meet another part of the
/// surface.
///
/// The vertices of a loop move apart by a fraction of the edges around them, all others stay; boundary
/// loops stay. Caps have the density of the loop's vertices. Vertices and faces of @p mesh come first,
/// in their order; the faces of caps have origin -1, their vertices are made of the loop's vertices.
/// @param mesh one component, oriented manifold, closed or with boundary.
/// @throws TopologyError if the mesh is not that, or a handle cannot be cut.
SurfaceWithoutHandles removeHandles(const TriangleMesh& mesh, const ProgressCallback& progress = {});

} // namespace flattening
