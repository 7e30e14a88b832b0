// SPDX-License-Identifier: GPL-3.0-or-later
/// Spreading of protrusions, which a conformal map shrinks below the resolution of doubles.
#pragma once

#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/ComplexPositions.h"

namespace flattening
{

/// Moves the vertices of protrusions apart in a conformal map.
///
/// A protrusion is a part of the surface that is longer than wide. Along it the conformal factor falls
/// exponentially with length over radius, soon below the resolution of doubles. Where @p logFactors
/// falls below @p logMeanFactor - log(1e5), it is made to fall a quarter as fast: the vertices there
/// move to the means of their neighbours with cotangent weights times the fourth power of the scale.
/// That flips no triangle of @p triangulation (see WeightedMeans) and moves nothing where the scale is
/// more than 20 times as large. The map is no longer conformal in the protrusions, where doubles cannot
/// be. Boundary vertices stay.
/// @param metric         factors in whose metric the cotangents are measured: @p logFactors if they make
///                       the triangulation flat to rounding, otherwise zeros, as triangles may
///                       degenerate
/// @param logFactors     log of flat over surface length, one per vertex
/// @param logMeanFactor  the same for the map as a whole
/// @param positions      positions in the map, one per vertex, changed in place
/// @returns the number of vertices in protrusions; with 0 nothing is moved.
/// @throws ConvergenceError as WeightedMeans
int spreadProtrusions(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& metric,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& positions);

} // namespace flattening
