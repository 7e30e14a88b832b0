// SPDX-License-Identifier: GPL-3.0-or-later
/// Optimal transport by a gradient flow that removes curl, a baseline for area-preserving maps.
#pragma once

#include "DiskFlow.h"

namespace flattening::benchmarks
{

/// The minimal flow of Angenent, Haker, Tannenbaum, "Minimizing flows for the Monge-Kantorovich problem"
/// (SIAM J. Math. Anal. 35, 2003), as Dominitz and Tannenbaum, "Texture mapping via optimal mass
/// transport" (IEEE TVCG 16, 2010) take it for surfaces, from their public descriptions and without
/// their multiresolution. u: conformal disk -> disk, to begin with @p start, which keeps areas; r is the
/// density of the surface's area in the conformal disk; f, 0 on the boundary, has the Laplacian curl u,
/// so that the turned gradient of f is the part of u that is no gradient; then du/dt = - Du (turned
/// gradient of f) / r, with differences against the stream. Areas are kept but for the size of the
/// steps. Ends when that part of u is a tenth of what it was at the start (root mean square), or after
/// @p seconds of processor time.
FlowResult minimalFlow(const TriangleMesh& mesh,
  const Points2& conformal,
  const Points2& start,
  double seconds);

} // namespace flattening::benchmarks
