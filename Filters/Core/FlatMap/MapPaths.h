// SPDX-License-Identifier: GPL-3.0-or-later
/// Distances within a flat map.
#pragma once

#include "Geodesics/GeodesicSearch.h"
#include "Mesh/TriangleMesh.h"

#include <memory>
#include <vector>

namespace flattening
{

/// A flat map as a sheet of paper: what lies between two places of its outline is not part of it. Where
/// faces are flipped, the paper is folded.
class MapPaper
{
public:
  /// @param flat  the positions of the vertices on the map (n x 2)
  MapPaper(const FaceMatrix& faces, const Points2& flat);

  /// Whether the map has one outline, and that is convex: then all shortest paths are straight.
  bool isConvex() const { return this->Convex; }

private:
  friend class MapPathSearch;
  const Points2& Flat;
  UnfoldableFaces Faces;
  bool Convex;
};

/// The lengths of the shortest paths within one map, for one thread.
class MapPathSearch
{
public:
  /// The paper must outlive the search.
  explicit MapPathSearch(const MapPaper& paper);

  /// The distances of @p targets from vertex @p source, in their order (units of the map); infinite
  /// where no path leads.
  std::vector<double> to(const std::vector<int>& targets,
    int source,
    const GeodesicSearch::Checkpoint& checkpoint = {});

private:
  const MapPaper& Paper;
  std::unique_ptr<GeodesicSearch> Search; // null if all paths are straight
};

} // namespace flattening
