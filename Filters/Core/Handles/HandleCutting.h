// SPDX-License-Identifier: GPL-3.0-or-later
/// Finds the handles of a surface one after the other and has them cut.
#pragma once

#include "Base/Progress.h"
#include "Handles/ShortLoops.h"
#include "Handles/TracedSurface.h"

#include <functional>
#include <vector>

namespace flattening
{

struct CutOutcome
{
  int FirstCopy = -1;    ///< the number that HalfedgeSurface::cut gave; -1 if the surface is as it was
  int Intersections = 0; ///< pairs of faces that intersect because of the cut, or would
};

/// Cuts the surface along the loop and closes both sides or leaves them open. Does nothing if that would
/// make more pairs of faces intersect than are tolerated. Numbers of pairs above @p counted need not be
/// told apart.
using CutAlong = std::function<CutOutcome(const SurfaceLoop& loop, int tolerated, int counted)>;

/// Cuts until the genus is 0, shortest loops first: among all loops up to some length, then up to a
/// longer one. No cut disconnects. Where the cut along a loop would make faces intersect, other loops of
/// its class and of other classes are tried; if it would for all of them, RejectedLoops chooses.
///
/// Loops avoid the boundary and what was left open. Where this is not possible, edges that join boundary
/// vertices across the surface are split in the middle, which leaves the surface as it is.
/// Returns the lengths of the loops in input units, one per handle, in the order of the cuts.
/// @throws TopologyError if the surface is not connected, or a handle cannot be cut.
std::vector<double> cutHandles(TracedSurface& surface,
  const CutAlong& cutAlong,
  const ProgressCallback& progress = {});

} // namespace flattening
