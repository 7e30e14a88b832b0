// SPDX-License-Identifier: GPL-3.0-or-later
/// Spreading of protrusions, which a conformal map shrinks below the resolution of doubles.
#pragma once

#include "Intrinsic/IntrinsicTriangulation.h"
#include "Mesh/ComplexPositions.h"

namespace flattening
{

/// Moves the vertices of protrusions apart in a conformal map.
///
/// A protrusion is a part of the surface that is longer than wide. Along a protrusion, the scale of a
/// conformal map (flat over surface length) falls exponentially with length over radius, and soon
/// doubles no longer resolve the positions. This function treats as protrusions the vertices whose scale
/// is below 1e-5 of the mean scale of the map: those whose element of @p logFactors is below @p
/// logMeanFactor - log(1e5). There it makes the scale fall about a quarter as fast as in the conformal
/// map.
///
/// To this end, vertices move to the weighted means of their neighbours. The weights are cotangent
/// weights, multiplied in the protrusions by the fourth power of the scale relative to 1e-5 of the mean.
/// Vertices whose scale is more than 20 times the one at which protrusions begin stay, unless the move
/// would then flip a triangle; in that case all inner vertices move. Boundary vertices stay: see
/// spreadAlongCircle(). The move flips no triangle of @p triangulation (see WeightedMeans).
/// In the protrusions the map is no longer conformal, but in doubles it could not be conformal there
/// anyway.
/// @param metric         factors in whose metric the cotangents are measured: @p logFactors if they make
///                       the triangulation flat to rounding, otherwise zeros, as triangles may
///                       degenerate
/// @param logFactors     log of flat over surface length, one per vertex
/// @param logMeanFactor  the same for the map as a whole
/// @param positions      positions in the map, one per vertex, changed in place
/// @param given          number of the first vertices that are those of the surface that the user gave,
///                       before others were added to it
/// @returns the number of given vertices in protrusions
/// @throws ConvergenceError as WeightedMeans
int spreadProtrusions(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& metric,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& positions,
  int given);

/// The map in which protrusions at the boundary are spread, too: the vertices of a part that hangs on
/// the rest by a narrow neck of the boundary would else share a few positions on the circle. Between two
/// boundary vertices that stay, the edges share the arc by lengths that fall about a quarter as fast in
/// the protrusions as on the conformal map; the inner vertices follow as in spreadProtrusions().
/// @param triangulation  whose boundary is that of the surface
/// @param faces          of the surface (m x 3)
/// @param conformal      the map to the unit circle before anything was spread
/// @param spread         the result of spreadProtrusions(), which is returned if no boundary vertex is
/// in
///                       a protrusion, or if fewer of its faces are flipped
ComplexVector spreadAlongCircle(const IntrinsicTriangulation& triangulation,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  const FaceMatrix& faces,
  const ComplexVector& conformal,
  const ComplexVector& spread);

} // namespace flattening
