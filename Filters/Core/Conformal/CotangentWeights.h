// SPDX-License-Identifier: GPL-3.0-or-later
/// The cotangent weights of the edges of an intrinsic triangulation.
#pragma once

#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/GraphLaplacian.h"

#include <vector>

namespace flattening
{

/// The edges of @p triangulation as springs with the cotangent weights at factors @p u, which are not
/// negative in a Delaunay triangulation, but for rounding. Edges of weight 0 are left out. In a flat
/// metric the coordinates of the vertices are in equilibrium.
std::vector<Spring> cotangentSprings(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& u);

} // namespace flattening
