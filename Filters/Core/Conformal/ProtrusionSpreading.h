// SPDX-License-Identifier: GPL-3.0-or-later
/// Parts of a conformal disk that are too small for what comes after it.
#pragma once

#include "Conformal/DiskNormalisation.h"
#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/ComplexPositions.h"

namespace flattening
{

/// Along a horn of the surface, a part longer than wide, the conformal map's scale falls exponentially
/// with length over radius, soon below what doubles tell apart. Where @p logFactors (of flat over
/// surface length, one per vertex) falls below 1e-5 of exp(@p logMeanFactor), it is made to fall a
/// quarter as fast: the positions @p disk of the vertices within are moved to the equilibrium of
/// cotangent springs that weaken with the fourth power of the scale, which turns no triangle of @p
/// triangulation over (see relaxSprings) and moves nothing where the scale is more than 20 times as
/// large. The map is no longer conformal in the horns, where no double could say so. Boundary vertices
/// stay.
/// @returns how many vertices lie in horns; with 0 nothing is moved.
/// @throws ConvergenceError as relaxSprings
int spreadProtrusions(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& disk);

/// The same with the springs' cotangents in the triangulation's own metric: for factors that do not make
/// it flat to rounding, and under which a triangle may degenerate.
int spreadProtrusionsInOwnMetric(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& disk);

} // namespace flattening
