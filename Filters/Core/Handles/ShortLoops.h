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

/// Searches a surface for loops from many vertices, in several threads (oneTBB). The result does not
/// depend on the number of threads. The surface and its labels may change between calls.
class ShortLoops
{
public:
  ShortLoops(const HalfedgeSurface& surface, const HomologyLabels& labels);

  /// Hashes of classes; loops of these classes are passed over.
  std::set<std::uint64_t> Ignored;

  /// Vertices of which every non-separating loop meets at least one: those at which an edge with a label
  /// other than zero starts.
  std::vector<int> seeds() const;

  /// If there is a loop that is not longer than @p length and meets one of the seeds, finds a loop that
  /// is not longer than twice that. Finds at most one loop from each seed, and none from a seed near to
  /// another one that was searched from. The loops are sorted by length.
  std::vector<SurfaceLoop> find(const std::vector<int>& seeds,
    double length,
    const ProgressCallback& progress = {});

  /// Searches from one vertex again, up to @p length or the length of the last find(), whichever is
  /// less. The loop has no half-edges if none was found.
  SurfaceLoop findAgain(int seed, double length);

  /// Searches from some vertices near to @p loop, up to @p length. The loops have no seed.
  std::vector<SurfaceLoop> findBeside(const SurfaceLoop& loop, double length);

  /// Whether a search since the last find() ended only because its loop would have been too long.
  bool wasBounded() const { return this->Bounded; }

  /// The hash of a loop's class.
  std::uint64_t classHash(const SurfaceLoop& loop) const;

  /// Replaces @p loop by a shorter one near to it as long as there is one.
  void tighten(SurfaceLoop& loop);

private:
  LoopSearch::Result search(int seed, double walk, double near);
  std::vector<LoopSearch::Result> searchAll(const std::vector<int>& seeds, double walk, double near);
  std::vector<int> verticesBeside(const SurfaceLoop& loop) const;

  const HalfedgeSurface& Surface;
  const HomologyLabels& Labels;
  tbb::enumerable_thread_specific<LoopSearch> Searches;
  double Length = 0.0; // the length up to which the last find() searched
  bool Bounded = false;
};

} // namespace flattening
