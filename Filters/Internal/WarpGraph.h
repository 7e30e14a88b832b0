// SPDX-License-Identifier: GPL-3.0-or-later
/// Graphs that Planar Warp carries.
#pragma once

#include "Internal/WarpRules.h"

class vtkGraph;

namespace flattening
{

/// Fills @p output, a vtkDirectedGraph or vtkUndirectedGraph as @p input is directed or not, with what
/// is carried of it: edges that lose a vertex go; edge points outside the mesh go from their edge alone.
/// @throws InvalidInput as requireSomeInside and segmentParts, and if the vertices have no positions.
CarryCounts warpGraph(vtkGraph* input, const WarpRules& rules, vtkGraph* output);

} // namespace flattening
