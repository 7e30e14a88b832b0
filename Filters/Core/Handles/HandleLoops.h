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
  /// The surface with the loops in its edges. It is the given mesh unless that is too coarse for loops
  /// that do not meet: then some edges are split in the middle, which leaves its shape as it is.
  DerivedMesh Surface;
  /// As many as the genus; vertices of Surface, neighbours are joined by edges. No vertex is in two of
  /// them, or in one of them twice, or on the boundary.
  std::vector<std::vector<int>> Loops;
  std::vector<double> Lengths; ///< input units
};

/// Finds short loops, one per handle (HandleCutting), such that the surface cut along all of them is
/// connected and planar (of genus 0).
/// @param mesh one component, oriented manifold, closed or with boundary.
/// @throws TopologyError if the mesh is not that.
HandleLoops handleLoops(const TriangleMesh& mesh, const ProgressCallback& progress = {});

} // namespace flattening
