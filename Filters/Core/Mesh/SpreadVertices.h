// SPDX-License-Identifier: GPL-3.0-or-later
/// Vertices that are spread evenly over a surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The vertices of the boundary @p loop of a disk, in their order, and after them inner ones, in theirs:
/// every vertex that is as far from all before it as the vertices were asked to be. Distances are along
/// edges. Near the boundary less is asked for, a share of the distance from the boundary, so that
/// triangles between the vertices can grow from there on.
/// @param spacing  how far the vertices should be from each other (> 0, input units)
/// @throws Cancelled.
std::vector<int> spreadVertices(const TriangleMesh& disk,
  const std::vector<int>& loop,
  double spacing,
  const ProgressCallback& progress = {});

} // namespace flattening
