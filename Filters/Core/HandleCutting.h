// SPDX-License-Identifier: GPL-3.0-or-later
/// Finds the handles of a surface one after the other and has them cut.
#pragma once

#include "Progress.h"
#include "ShortLoops.h"
#include "TracedSurface.h"

#include <functional>
#include <vector>

namespace flattening
{

/// Cuts the surface along the loop, closes both sides or leaves them open, and returns the number that
/// HalfedgeSurface::cut gave. Returns -1, with the surface unchanged, if another loop would be better;
/// not allowed if @p last.
using CutAlong = std::function<int(const SurfaceLoop& loop, bool last)>;

/// Cuts until the genus is 0, shortest loops first: among all loops up to some length, then up to a
/// longer one. No cut disconnects. Where a loop is refused, the next longer ones of other classes are
/// offered, up to twice its length, until it is offered for the last time.
///
/// Loops avoid the boundary and what was left open. Where this is not possible, edges that join boundary
/// vertices across the surface are split in the middle, which leaves the surface as it is.
/// Returns the lengths of the loops in input units, one per handle, in the order of the cuts.
/// @throws TopologyError if the surface is not connected, or a handle cannot be cut.
std::vector<double> cutHandles(TracedSurface& surface,
  const CutAlong& cutAlong,
  const ProgressCallback& progress = {});

} // namespace flattening
