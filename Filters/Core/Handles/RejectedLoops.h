// SPDX-License-Identifier: GPL-3.0-or-later
/// Loops along which no cut was made because faces would intersect, and the choice among them.
#pragma once

#include "Handles/ShortLoops.h"

#include <functional>
#include <vector>

namespace flattening
{

class RejectedLoops
{
public:
  static constexpr int Few = 32; ///< pairs of faces that intersect; smoothing takes them apart

  /// @param longestDetour see due(), input units.
  explicit RejectedLoops(double longestDetour);

  /// @p intersections: pairs of faces that would intersect.
  void add(SurfaceLoop loop, int intersections);
  bool contains(const SurfaceLoop& loop) const;

  /// Drops the loops that do not satisfy @p stillCuttable.
  void keepIf(const std::function<bool(const SurfaceLoop&)>& stillCuttable);

  void visit(const std::function<void(const SurfaceLoop&, int intersections)>& visit) const;

  /// The least length; 0 if there is none.
  double shortest() const;

  /// The length up to which loops may be cut instead of one that many faces are in the way of; infinite
  /// if there is none.
  double limit() const;

  /// The loop that must be cut all the same; null if there is none. Where more than Few pairs would
  /// intersect, as where a whole fold lies in the way, a loop is given up for one that is up to 1.5
  /// times as long, but not longer by more than the longest detour. Of the refused loops within the
  /// length the one is taken with the least product of its length and the pairs that would intersect.
  /// @param searched length up to which loops were looked for everywhere.
  /// @param tried length up to which all that were found were tried.
  const SurfaceLoop* due(double searched, double tried) const;

private:
  struct Refused
  {
    SurfaceLoop Loop;
    int Intersections;

    double cost() const;
  };
  double longestInstead(const Refused& refused) const;

  double LongestDetour;
  std::vector<Refused> All;
};

} // namespace flattening
