// SPDX-License-Identifier: GPL-3.0-or-later
/// A search for a short loop that starts from one vertex.
#pragma once

#include "Handles/HalfedgeSurface.h"
#include "Handles/HomologyLabels.h"

#include <cstdint>
#include <functional>
#include <queue>
#include <set>
#include <utility>
#include <vector>

namespace flattening
{

struct SurfaceLoop
{
  double Length = 0.0;        ///< input units
  std::vector<int> Halfedges; ///< each starts where the one before it ends; no vertex twice
  int Seed = -1;              ///< the vertex from which the search for it started; -1 if not known
};

/// A Dijkstra search that carries the homology label of the path (compare Erickson, Har-Peled 2004,
/// "Optimally cutting a surface into a disk"; Dey, Fan, Wang 2013, "An efficient computation of handle
/// and tunnel loops via Reeb graphs"): an edge between two reached vertices closes a loop that does not
/// bound if the sum of their labels and its own is not zero. Loops avoid the boundary.
///
/// CGAL's Surface_mesh_topology finds shortest non-contractible loops. These may separate the surface,
/// and a cut along them would remove no handle.
///
/// The memory of a search grows with the surface, but only the part that a search reaches is written.
/// One thread at a time may use an object; several objects may search the same surface.
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
    SurfaceLoop Loop;        ///< without half-edges if no loop was found
    std::vector<int> Near;   ///< vertices within the radius asked for, among them the seed
    bool WasBounded = false; ///< whether no loop was found, but a longer walk might have found one
  };

  /// Finds the shortest closed walk from the seed around a loop, and returns the loop without the path
  /// to it.
  /// @param walk the longest walk, input units.
  /// @param near radius for Result::Near; negative for none.
  /// @param ignored hashes of classes; loops of these classes are passed over.
  Result shortestFrom(int seed, double walk, double near, const std::set<std::uint64_t>& ignored);

private:
  struct Reached
  {
    double Distance;
    std::uint64_t Hash; // of the path's labels
    int Edge;           // the last half-edge of the path, -1 at the seed
    int Search;         // the search that wrote this, negative once the distance is final
  };

  using Entry = std::pair<double, int>; // distance, vertex

  bool isSettled(int v) const { return this->Vertices[v].Search == -this->Searches; }
  void reach(int v, const Reached& how);
  void follow(int h, const std::set<std::uint64_t>& ignored);
  std::vector<int> pathTo(int v) const;
  SurfaceLoop closedLoop(int seed) const;

  const HalfedgeSurface& Surface;
  const HomologyLabels& Labels;
  std::vector<Reached> Vertices;
  int Searches = 0;
  // The search that runs.
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Queue;
  double ShortestWalk = 0.0;
  int Closing = -1; // the half-edge that closes the shortest walk
  bool WasBounded = false;
};

} // namespace flattening
