// SPDX-License-Identifier: GPL-3.0-or-later
/// Planar Warp of graphs.
#pragma once

#include "Internal/WarpRules.h"

class vtkGraph;

namespace flattening
{

/// Fills @p output, a vtkDirectedGraph or vtkUndirectedGraph like @p input, with the warped graph. If
/// points outside the mesh are removed, edges that lose a vertex are removed, too; an edge point outside
/// the mesh is removed alone.
/// @throws InvalidInput as requireSomeInside and segmentParts do, and if the vertices have no positions.
WarpCounts warpGraph(vtkGraph* input, const WarpRules& rules, vtkGraph* output);

} // namespace flattening
