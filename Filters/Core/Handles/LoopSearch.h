// SPDX-License-Identifier: GPL-3.0-or-later
/// One search for a short loop from a vertex.
#pragma once

#include "Handles/HalfedgeSurface.h"
#include "Handles/HomologyLabels.h"

#include <cstdint>
#include <set>
#include <vector>

namespace flattening
{

struct SurfaceLoop
{
  double Length = 0.0;        ///< input units
  std::vector<int> Halfedges; ///< each starts where the one before it ends; no vertex twice
  int Seed = -1;              ///< the vertex from which it was found
};

/// A Dijkstra search that carries the homology label of the path (compare Erickson, Har-Peled 2004,
/// "Optimally cutting a surface into a disk"; Dey, Fan, Wang 2013, "An efficient computation of handle
/// and tunnel loops via Reeb graphs"): an edge that joins two reached vertices whose labels and its own
/// do not cancel closes a loop that does not bound. Loops avoid the boundary.
///
/// Its memory grows with the surface, but is only written where a search comes by. One thread at a time
/// may use it, several may search the same surface with one each.
class LoopSearch
{
public:
  LoopSearch(const HalfedgeSurface& surface, const HomologyLabels& labels)
    : Surface(surface)
    , Labels(labels)
  {
  }

  struct Result
  {
    SurfaceLoop Loop;        ///< no half-edges if there is none
    std::vector<int> Near;   ///< vertices within the radius asked for, the seed among them
    bool WasBounded = false; ///< there is no loop, but a longer walk might have given one
  };

  /// The shortest closed walk from the seed, at most of the length @p walk, around a loop whose class
  /// has none of the hashes in @p ignored; its path to the loop itself is left out.
  /// @param near radius for Result::Near; negative for none.
  Result shortestFrom(int seed, double walk, double near, const std::set<std::uint64_t>& ignored);

private:
  struct Reached
  {
    double Distance;
    std::uint64_t Hash; // of the path's labels
    int Edge;           // the last half-edge of the path, -1 at the seed
    int Search;         // the search that wrote this, negative once the distance is final
  };

  SurfaceLoop loopThrough(int closing, int seed) const;

  const HalfedgeSurface& Surface;
  const HomologyLabels& Labels;
  std::vector<Reached> Vertices;
  int Searches = 0;
};

} // namespace flattening
