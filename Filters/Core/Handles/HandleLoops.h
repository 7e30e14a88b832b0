// SPDX-License-Identifier: GPL-3.0-or-later
/// Loops along which a surface must be cut to have no handle.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

#include <vector>

namespace flattening
{

struct HandleLoops
{
  /// A surface of the same shape whose edges form the loops. It is the given mesh unless that is too
  /// coarse for loops that do not meet: then some edges are split in the middle.
  DerivedMesh Surface;
  /// As many loops as the genus, each a list of vertices of Surface in which edges join neighbours. No
  /// vertex belongs to two loops, to one of them twice, or to the boundary.
  std::vector<std::vector<int>> Loops;
  std::vector<double> Lengths; ///< of the loops, input units
};

/// Finds short loops, one per handle (cutHandles), such that the surface cut along all of them is
/// connected and planar (of genus 0).
/// @param mesh one component, oriented manifold, closed or with boundary.
/// @throws TopologyError if the mesh is not that, or a handle cannot be cut; Cancelled.
HandleLoops handleLoops(const TriangleMesh& mesh, const ProgressCallback& progress = {});

} // namespace flattening
