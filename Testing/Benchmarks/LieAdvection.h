// SPDX-License-Identifier: GPL-3.0-or-later
/// Areas restored by a flow along the gradient of a potential, a baseline for area-preserving maps.
#pragma once

#include "DiskFlow.h"

namespace flattening::benchmarks
{

/// After Zou, Hu, Gu, Hua, "Authalic parameterization of general surfaces using Lie advection", IEEE
/// TVCG 17 (2011), from its public description: from the conformal map on the flat area element is
/// advected towards the surface's, along the velocity grad x / r, where r is surface over flat area,
/// Laplace of x is r - 1, and no velocity crosses the boundary. Each step solves that on the triangles
/// as they lie, with a factorization of its own. It lasts the time in which excess areas decay by e, a
/// half or a quarter of that, if no face loses four fifths of its area; else a quarter, and no vertex
/// moves farther than 0.3 of the least altitude around it. Ends when the areas of vertices (a third of
/// the faces around them) are off by @p tolerance on average; without a result when a face has
/// collapsed, which the areas of vertices do not prevent, or after @p seconds of processor time.
/// @param conformal the conformal map to the unit disk, without flipped faces.
FlowResult lieAdvection(const TriangleMesh& mesh,
  const Points2& conformal,
  double tolerance,
  double seconds);

} // namespace flattening::benchmarks
