// SPDX-License-Identifier: GPL-3.0-or-later
/// Finds short loops around the handles of a surface, one after the other, and has them cut.
#pragma once

#include "Base/Progress.h"
#include "Handles/ShortLoops.h"

#include <functional>
#include <vector>

namespace flattening
{

struct CutOutcome
{
  int FirstCopy = -1;    ///< the number that HalfedgeSurface::cut gave; -1 if there was no cut
  int Intersections = 0; ///< pairs of faces that intersect because of the cut, or would
};

/// Cuts the surface along the loop and closes both sides or leaves them open. Does nothing if that would
/// make more than @p tolerated pairs of faces intersect. May stop to count pairs above @p counted.
using CutAlong = std::function<CutOutcome(const SurfaceLoop& loop, int tolerated, int counted)>;

/// Cuts until the genus is 0, shortest loops first: all loops up to some length, then all up to a longer
/// one. No cut disconnects the surface. Where the cut along a loop would make faces intersect, the loop
/// is rejected, and other loops of its class and of other classes are tried; if these are rejected too,
/// RejectedLoops chooses one.
///
/// Loops avoid the boundary and cuts that were left open. Where no loop can, edges that join boundary
/// vertices across the surface are split in the middle, which does not change the surface's shape.
/// Returns the lengths of the loops in input units, one per handle, in the order of the cuts.
/// @throws TopologyError if the surface is not connected, or a handle cannot be cut.
std::vector<double> cutHandles(HalfedgeSurface& surface,
  const CutAlong& cutAlong,
  const ProgressCallback& progress = {});

} // namespace flattening
