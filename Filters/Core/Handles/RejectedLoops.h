// SPDX-License-Identifier: GPL-3.0-or-later
/// Loops that were rejected because faces would intersect after a cut along them, and the choice of one
/// that is cut all the same.
#pragma once

#include "Handles/ShortLoops.h"

#include <functional>
#include <vector>

namespace flattening
{

class RejectedLoops
{
public:
  /// As many pairs of intersecting faces are removed by smoothing afterwards. Observed: a cap through a
  /// fold makes hundreds or thousands. With a larger number more caps pass through folds, with a smaller
  /// one longer loops are cut.
  static constexpr int Few = 32;

  /// @param longestDetour see due(), input units.
  explicit RejectedLoops(double longestDetour);

  /// @p intersections: the number of pairs of faces that would intersect.
  void add(SurfaceLoop loop, int intersections);
  bool contains(const SurfaceLoop& loop) const;

  /// Drops the loops that do not satisfy @p stillCuttable.
  void keepIf(const std::function<bool(const SurfaceLoop&)>& stillCuttable);

  void visit(const std::function<void(const SurfaceLoop&, int intersections)>& visit) const;

  /// The length of the shortest loop; 0 if there is none.
  double shortest() const;

  /// The length up to which other loops are tried instead of the loops with more than Few intersections;
  /// infinite if there is no such loop.
  double limit() const;

  /// The loop that is cut now because no better one was found; null if there is none. A loop with at
  /// most Few intersections waits for no longer one; a loop with more, as where a whole fold lies in the
  /// way, waits for loops up to 1.5 times as long, but not longer by more than the longest detour. Of
  /// all rejected loops up to that length the one with the least product of length and intersections is
  /// due.
  /// @param searched length up to which loops were searched for everywhere.
  /// @param tried length up to which all loops that were found were tried.
  const SurfaceLoop* due(double searched, double tried) const;

private:
  struct Rejected
  {
    SurfaceLoop Loop;
    int Intersections;

    double cost() const;
  };
  /// The length up to which other loops are tried instead.
  double longestInstead(const Rejected& rejected) const;

  double LongestDetour;
  std::vector<Rejected> All;
};

} // namespace flattening
