// SPDX-License-Identifier: GPL-3.0-or-later
/// The cotangent weights of the edges of an intrinsic triangulation.
#pragma once

#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/GraphLaplacian.h"

#include <vector>

namespace flattening
{

/// The cotangent weights of the inner edges of @p triangulation at factors @p u, for both ends of each.
/// They are not negative in a Delaunay triangulation, but for rounding; only positive ones are listed.
/// In a flat metric the positions of inner vertices are the means with these weights.
std::vector<NeighbourWeight> cotangentWeights(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& u);

} // namespace flattening
