// SPDX-License-Identifier: GPL-3.0-or-later
/// Where points of the plane lie on a flat map, and points in space on the surface that it is of.
#pragma once

#include "Base/Progress.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/ClosestPointWalk.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace flattening
{

/// A place on a flat map and on its surface at once: the same weights in the same face.
struct MapPlace
{
  int Face;
  std::array<double, 3> Weights; ///< barycentric, >= 0, sum 1, in the order of the face's vertices
  double Distance;               ///< of what was asked for from the place, input units
  bool Inside;                   ///< whether that is within FlatMapLocation::Rounding
};

/// Answers both with CGAL's AABB trees. On a bijective map going there and back loses nothing but
/// rounding: a place is off by about 1e-16 of the diagonal, times the length over the height of a thin
/// triangle, times how much the map shrinks there. Of several faces that share a place (at an edge or
/// vertex, or where a map folds over) one is answered, always the same.
class FlatMapLocation
{
public:
  /// What is no farther away than this, as a share of the diagonal of the bounding box, counts as
  /// inside: a point computed on the map's boundary lies beyond it by rounding half of the time.
  static constexpr double Rounding = 1e-12;

  /// @p surface and @p positions (n x 2) share vertices and faces. Copies both.
  /// With @p progress an abort does not wait for the search tree.
  /// @throws InvalidInput if a coordinate is not finite, the sizes differ, or no face has an area in the
  /// map; Cancelled.
  FlatMapLocation(const TriangleMesh& surface,
    const Points2& positions,
    const ProgressCallback& progress = {});

  /// The place on the map nearest to @p point of the plane; Distance is in the plane.
  /// @throws InvalidInput if it is not finite.
  MapPlace onMap(const Eigen::RowVector2d& point) const;

  /// The same where a face nearby is known, such as that of the point looked up before: ten times as
  /// fast for points inside. Of several faces that share the place it may answer another.
  MapPlace onMap(const Eigen::RowVector2d& point, int nearFace) const;

  /// Does now, with progress, what the first onSurface() does else.
  /// @throws InvalidInput if no face has an area on the surface.
  void prepareSurface(const ProgressCallback& progress) const;

  /// The place on the surface nearest to @p point in space; Distance is in space.
  /// @throws InvalidInput if it is not finite or no face has an area on the surface.
  MapPlace onSurface(const Eigen::RowVector3d& point) const;

  /// Where a place is on the surface, and in the plane.
  Eigen::RowVector3d surfacePoint(const MapPlace& place) const;
  Eigen::RowVector2d mapPoint(const MapPlace& place) const;

private:
  // The faces of a mesh that have an area, which alone can be looked up, and their numbers in the whole.
  struct Searched
  {
    Searched(TriangleMesh whole, const ProgressCallback& progress);
    MapPlace nearest(const Eigen::RowVector3d& point) const;

    TriangleMesh Mesh;
    std::vector<int> Faces;
    std::vector<int> NumberOf; // the other way round; -1: has no area
    double Diagonal;
    std::unique_ptr<ClosestPointTree> Projection;
  };

  TriangleMesh Surface;
  Points2 Positions;
  Searched Map;
  ClosestPointWalk MapWalk;
  mutable std::once_flag SpaceSearched; // most look up on the map alone
  mutable std::unique_ptr<Searched> Space;
};

} // namespace flattening
