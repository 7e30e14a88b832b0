// SPDX-License-Identifier: GPL-3.0-or-later
/// From a flat metric with a straight boundary to positions in the upper half-plane.
#pragma once

#include "Base/Progress.h"
#include "Base/SparseFactorization.h"
#include "Conformal/DiskNormalisation.h"
#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/ComplexPositions.h"

namespace flattening
{

/// Positions of the vertices of @p triangulation at factors @p u, for which it is flat and its mirror
/// straight; the mirror, from boundary edge @p firstEdge on, becomes the real axis, and the rest of the
/// boundary is the link of the vertex at infinity. Coordinates are harmonic in a flat metric, so with
/// the boundary known one linear solve gives them all; laying out face by face from the boundary would
/// be a Cauchy problem, whose rounding errors grow exponentially. Vertices that are neither on the
/// boundary nor on a face get (infinity, 0).
/// @param order  as for relaxSprings
/// @throws ConvergenceError if the linear system cannot be factored; Cancelled.
ComplexVector layOutInHalfPlane(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& u,
  int firstEdge,
  const EliminationOrder& order = {},
  const ProgressCallback& progress = {});

/// Greatest error of an edge's length in @p position, relative to that length or to 1e-11 of the
/// layout's extent, whichever is longer: no shorter edge is resolved by positions in double precision.
double layoutError(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& u,
  const ComplexVector& position);

/// @throws ConvergenceError if such an error is too large for a map.
void requireLayout(double layoutError);

} // namespace flattening
