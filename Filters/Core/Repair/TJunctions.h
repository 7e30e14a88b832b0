// SPDX-License-Identifier: GPL-3.0-or-later
/// Cracks without width: points in the middle of open edges ("T-junctions").
#pragma once

#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace flattening
{

/// Splits every face whose open edge (an edge of one face only) has ends of other open edges on it at
/// these, so that the faces on the other side fit. On it means: off its ends, and not farther from it
/// than @p tolerance (input units) or 1e-10 of its length, whichever is more, nor than a tenth of the
/// face's height over it.
/// @p faces (no repeated vertices) and @p origins (what each face is a part of) change together; parts
/// hand the origin on. Returns the number of places where an edge was split.
int closeCracks(const Points3& vertices,
  std::vector<std::array<int, 3>>& faces,
  std::vector<int>& origins,
  double tolerance = 0.0);

} // namespace flattening
