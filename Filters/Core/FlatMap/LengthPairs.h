// SPDX-License-Identifier: GPL-3.0-or-later
/// The lengths between source points and other points, on a surface and on its flat map.
#pragma once

#include "Base/Progress.h"
#include "FlatMap/LengthErrors.h"
#include "FlatMap/MapPaths.h"
#include "Geodesics/GeodesicSearch.h"
#include "Geodesics/UnfoldableFaces.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <tbb/enumerable_thread_specific.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace flattening
{

/// Lengths between one source and the points near it.
struct LocalLengths
{
  std::vector<int> Vertices; ///< the others of the pairs in Local
  SourceLengths Local;       ///< on the surface with closed seams, and straight on the map
  SourceLengths WithinMap;   ///< on the surface as it was opened, and within the map
  SourceLengths Rings;       ///< on the surface as it was opened, and straight on the map; weights 1
};

/// Measures lengths between vertices that it draws as sources and other vertices. The pairs of a source
/// weigh as much as the areas of the surface around the others.
class LengthPairs
{
public:
  /// The positions @p flat (n x 2) are those of the vertices on the map. Both must outlive this.
  LengthPairs(const TriangleMesh& surface, const Points2& flat);

  /// The lengths of the sources to the vertices no farther than @p radius on the surface, and to those
  /// within seven rings of edges. Where a vertex of hundreds of edges brings more than 1000 vertices
  /// into the rings of a source, only those of them no farther than @p radius count. Up to @p samples
  /// vertices are sources: as many as that where the radius reaches over a small part of the surface,
  /// down to a sixteenth where it reaches over all of it, but at least 2. A source takes as much longer
  /// as its radius reaches over more, and what is measured over most of the surface differs less from
  /// source to source.
  /// @param samples  at least 2
  /// @param radius   input units, > 0
  /// @throws InvalidInput if the lengths do not fit into memory; Cancelled.
  std::vector<LocalLengths> local(int samples, double radius, const ProgressCallback& progress);

  /// The lengths of @p samples sources to all vertices, on the surface with closed seams and straight on
  /// the map. @throws Cancelled
  std::vector<SourceLengths> global(int samples, const ProgressCallback& progress);

private:
  // The part of the surface that a search needs, for each thread.
  struct Searches
  {
    GeodesicSearch Closed;
    GeodesicSearch Open;
    MapPathSearch Map;
    std::vector<char> IsFound; // per vertex; used by ringsAround()
  };
  using SourceTask = std::function<void(std::size_t, Searches&, const GeodesicSearch::Checkpoint&)>;

  std::vector<int> sources(int count) const;
  void forEachSource(const std::vector<std::size_t>& sources,
    const SourceTask& task,
    const char* stage,
    const ProgressCallback& progress);
  LocalLengths localLengthsOf(int source,
    double radius,
    Searches& searches,
    const GeodesicSearch::Checkpoint& check) const;
  bool addStraight(int source, const ReachedVertex& other, SourceLengths& lengths) const;
  void addWithinMap(int source,
    const std::vector<ReachedVertex>& near,
    MapPathSearch& map,
    const GeodesicSearch::Checkpoint& check,
    SourceLengths& lengths) const;
  std::vector<ReachedVertex> inRings(int source,
    const std::vector<ReachedVertex>& near,
    Searches& searches,
    const GeodesicSearch::Checkpoint& check) const;
  std::vector<int> ringsAround(int source, std::vector<char>& isFound) const;
  double straight(int source, const ReachedVertex& other) const;
  bool add(const ReachedVertex& other, double onMap, double weight, SourceLengths& lengths) const;

  const TriangleMesh& Surface;
  const Points2& Flat;
  Eigen::VectorXd Areas; // of the surface around the vertices
  UnfoldableFaces Open;
  UnfoldableFaces Closed;
  MapPaper Paper;
  tbb::enumerable_thread_specific<Searches> SearchesOfThreads;
};

} // namespace flattening
