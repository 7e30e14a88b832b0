// SPDX-License-Identifier: GPL-3.0-or-later
/// Embedding of a flat metric with a straight boundary in the upper half-plane.
#pragma once

#include "Base/Progress.h"
#include "Base/SparseFactorization.h"
#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/ComplexPositions.h"

namespace flattening
{

/// Positions of the vertices of @p triangulation in the upper half-plane. At factors @p u the
/// triangulation must be flat and its mirror straight. The mirror, from boundary edge @p firstEdge on,
/// becomes the real axis; the rest of the boundary is the link of the vertex at infinity. @p order is an
/// order of elimination for WeightedMeans.
///
/// Coordinates are harmonic in a flat metric, so that one linear solve gives them all once the boundary
/// is known. Laying out face by face from the boundary would be a Cauchy problem, whose rounding errors
/// grow exponentially. Vertices that are neither on the boundary nor on a face get (infinity, 0).
/// @throws ConvergenceError if the linear system cannot be factored; Cancelled.
ComplexVector embedInHalfPlane(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& u,
  int firstEdge,
  const EliminationOrder& order = {},
  const ProgressCallback& progress = {});

/// The greatest error of an edge's length in @p position, relative to that length or to 1e-11 of the
/// embedding's extent, whichever is longer: double precision does not resolve shorter edges.
double layoutError(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& u,
  const ComplexVector& position);

/// @throws ConvergenceError if the layout error is too large for a map.
void requireLayout(double layoutError);

} // namespace flattening
