// SPDX-License-Identifier: GPL-3.0-or-later
/// Vertices that are spread evenly over a surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Chooses the vertices of the boundary @p loop of a disk and, in ascending order, every inner vertex
/// that is at least @p spacing from all chosen before it. Distances are along edges. Near the boundary
/// 0.7 times the distance from it is enough, so that the triangles between the vertices grow from there
/// on. Returns those of the boundary, in their order, and then the inner ones.
/// @param spacing  how far the vertices should be from each other (> 0, input units)
/// @throws Cancelled.
std::vector<int> spreadVertices(const TriangleMesh& disk,
  const std::vector<int>& loop,
  double spacing,
  const ProgressCallback& progress = {});

} // namespace flattening
