// SPDX-License-Identifier: GPL-3.0-or-later
/// Loops along which no cut was made because faces would intersect, and the choice among them.
#pragma once

#include "ShortLoops.h"

#include <functional>
#include <vector>

namespace flattening
{

class RefusedLoops
{
public:
  /// @p intersections: pairs of faces that would intersect.
  void add(SurfaceLoop loop, int intersections);
  bool contains(const SurfaceLoop& loop) const;

  /// Drops the loops that do not satisfy @p stillCuttable.
  void keepIf(const std::function<bool(const SurfaceLoop&)>& stillCuttable);

  /// The loop that must be cut all the same, now that all loops up to @p length were tried; null if
  /// there is none. Where more than 32 pairs would intersect, as where a whole fold lies in the way, a
  /// loop is given up for one that is up to 1.5 times as long. Of the refused loops within the length
  /// the one is taken for which the fewest faces intersect.
  const SurfaceLoop* due(double length) const;

private:
  struct Refused
  {
    SurfaceLoop Loop;
    int Intersections;

    double longestInstead() const;
  };
  std::vector<Refused> All;
};

} // namespace flattening
