// SPDX-License-Identifier: GPL-3.0-or-later
/// Triangles whose corners lie on one line.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace flattening
{

/// Removes every face whose altitude is below 1e-10 of its longest edge, but for needles
/// (collapseNeedles). Dropping it alone would leave a crack, so the faces beyond its longest edge are
/// split at the vertex that lies on that edge.
/// @p faces (no repeated vertices) and @p origins (what each face is a part of) change together; split
/// faces hand their origin on. Returns the number of faces that were collinear at the start.
int dissolveCollinearFaces(const Points3& vertices,
  std::vector<std::array<int, 3>>& faces,
  std::vector<int>& origins);

} // namespace flattening
