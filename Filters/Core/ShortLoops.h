// SPDX-License-Identifier: GPL-3.0-or-later
/// Short closed loops of edges that do not separate a surface.
#pragma once

#include "HalfedgeSurface.h"
#include "HomologyLabels.h"
#include "Progress.h"

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

/// Finds loops by Dijkstra searches that carry the homology label of the path (compare Erickson,
/// Har-Peled 2004, "Optimally cutting a surface into a disk"; Dey, Fan, Wang 2013, "An efficient
/// computation of handle and tunnel loops via Reeb graphs"): an edge that joins two reached vertices
/// whose labels and its own do not cancel closes a loop that does not bound. Loops avoid the boundary.
///
/// The surface and its labels may change between calls.
class ShortLoops
{
public:
  ShortLoops(const HalfedgeSurface& surface, const HomologyLabels& labels)
    : Surface(surface)
    , Labels(labels)
  {
  }

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

  /// The same from one vertex, for the same length as the last find(). No half-edges if there is none.
  SurfaceLoop findAgain(int seed);

  /// Whether some search since the last find() ended only because its loop would have been too long.
  bool wasBounded() const { return this->Bounded; }

  /// The hash of a loop's class.
  std::uint64_t classHash(const SurfaceLoop& loop) const;

  /// Replaces @p loop by a shorter one near to it while there is one.
  void tighten(SurfaceLoop& loop);

private:
  struct Reached
  {
    double Distance;
    std::uint64_t Hash; // of the path's labels
    int Edge;           // the last half-edge of the path, -1 at the seed
    int Search;         // the search that wrote this
    bool Settled;
  };

  // The shortest closed walk from the seed, at most of that length; its path to the loop itself is left
  // out. No half-edges if there is none. Vertices nearer than `near` are covered.
  SurfaceLoop shortestFrom(int seed, double walk, double near);
  SurfaceLoop loopThrough(int closing, int seed) const;

  const HalfedgeSurface& Surface;
  const HomologyLabels& Labels;
  std::vector<Reached> Vertices;
  std::vector<int> Covered; // the find() in which the vertex was
  int Searches = 0;
  int Finds = 0;
  double Length = 0.0; // of the last find()
  bool Bounded = false;
};

} // namespace flattening
