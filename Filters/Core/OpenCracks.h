// SPDX-License-Identifier: GPL-3.0-or-later
/// Cracks without width: points in the middle of open edges ("T-junctions").
#pragma once

#include "TriangleMesh.h"

#include <array>
#include <vector>

namespace flattening
{

/// Splits every face whose open edge (an edge of one face only) has vertices of other open edges on it
/// at these, so that the faces on the other side fit. On it means: within @p tolerance (input units) or
/// 1e-10 of the edge's length, whichever is more, off its ends, and beyond a tenth of that from the
/// face's third corner.
/// @p faces (no repeated vertices) and @p origins (what each face is a part of) change together; parts
/// hand the origin on. Returns the number of places where an edge was split.
int closeCracks(const Points3& vertices,
  std::vector<std::array<int, 3>>& faces,
  std::vector<int>& origins,
  double tolerance = 0.0);

} // namespace flattening
