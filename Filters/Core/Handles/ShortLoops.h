// SPDX-License-Identifier: GPL-3.0-or-later
/// Short closed loops of edges that do not separate a surface.
#pragma once

#include "Base/Progress.h"
#include "Handles/LoopSearch.h"

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <set>
#include <vector>

namespace flattening
{

/// Searches a surface for loops from many vertices, in several threads (oneTBB); what it finds does not
/// depend on their number.
///
/// The surface and its labels may change between calls.
class ShortLoops
{
public:
  ShortLoops(const HalfedgeSurface& surface, const HomologyLabels& labels);

  /// Loops whose class has one of these hashes are passed over.
  std::set<std::uint64_t> Ignored;

  /// For a set of vertices that every such loop meets: the vertices at which an edge with a label
  /// starts.
  std::vector<int> seeds() const;

  /// If there is a loop that is not longer than @p length and meets one of the vertices, finds one that
  /// is not longer than twice that. Finds at most one loop from each of the vertices, and none from
  /// those near to others that were searched from. Sorted by length.
  std::vector<SurfaceLoop> find(const std::vector<int>& seeds,
    double length,
    const ProgressCallback& progress = {});

  /// The same from one vertex, for @p length or that of the last find() if it was less. No half-edges if
  /// there is none.
  SurfaceLoop findAgain(int seed, double length);

  /// Loops from some vertices near to @p loop, not longer than @p length, without a seed.
  std::vector<SurfaceLoop> findBeside(const SurfaceLoop& loop, double length);

  /// Whether some search since the last find() ended only because its loop would have been too long.
  bool wasBounded() const { return this->Bounded; }

  /// The hash of a loop's class.
  std::uint64_t classHash(const SurfaceLoop& loop) const;

  /// Replaces @p loop by a shorter one near to it while there is one.
  void tighten(SurfaceLoop& loop);

private:
  LoopSearch::Result search(int seed, double walk, double near);
  std::vector<LoopSearch::Result> searchAll(const std::vector<int>& seeds, double walk, double near);
  std::vector<int> verticesBeside(const SurfaceLoop& loop) const;

  const HalfedgeSurface& Surface;
  const HomologyLabels& Labels;
  tbb::enumerable_thread_specific<LoopSearch> Searches;
  double Length = 0.0; // of the last find()
  bool Bounded = false;
};

} // namespace flattening
