// SPDX-License-Identifier: GPL-3.0-or-later
/// The cotangent weights of the edges of an intrinsic triangulation.
#pragma once

#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/GraphLaplacian.h"

#include <vector>

namespace flattening
{

/// The edges of @p triangulation with their cotangent weights at factors @p u, which are not negative in
/// a Delaunay triangulation but for rounding: in a flat metric coordinates are in equilibrium.
std::vector<Spring> springsOf(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& u);

} // namespace flattening
