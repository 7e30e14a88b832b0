// SPDX-License-Identifier: GPL-3.0-or-later
/// Point location on a flat map and on its surface in space.
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

/// A flat map as a mesh in space, at z = 0.
TriangleMesh planarMesh(const Points2& positions, const FaceMatrix& faces);

/// A place on a flat map and on its surface at once: the same weights in the same face.
struct MapPlace
{
  int Face;
  std::array<double, 3> Weights; ///< barycentric, >= 0, sum 1, in the order of the face's vertices
  double Distance;               ///< distance of the query point from the place, input units
  bool Inside;                   ///< whether the distance is at most FlatMapLocation::Rounding
};

/// Finds the place on the map or on the surface that is nearest to a point, by CGAL's AABB trees. On a
/// bijective map the way there and back loses only rounding: a place is off by about 1e-16 of the
/// diagonal, times the ratio of length to height of a thin triangle, times the factor by which the map
/// shrinks there. If several faces share a place (at an edge or vertex, or where a map folds over), the
/// answer is one of them, always the same.
class FlatMapLocation
{
public:
  /// A point is outside if it is farther away than this share of the diagonal of the bounding box. A
  /// point computed on the boundary of the map lies beyond it by rounding, about 1e-16, half of the
  /// time; with a smaller value such points are lost.
  static constexpr double Rounding = 1e-12;

  /// @p surface and @p positions (n x 2) share vertices and faces. Copies both.
  /// With @p progress an abort need not wait until the search tree is built.
  /// @throws InvalidInput if a coordinate is not finite, the sizes differ, or no face has an area in the
  /// map; Cancelled.
  FlatMapLocation(const TriangleMesh& surface,
    const Points2& positions,
    const ProgressCallback& progress = {});

  /// The place on the map nearest to @p point of the plane; Distance is in the plane.
  /// @throws InvalidInput if it is not finite.
  MapPlace onMap(const Eigen::RowVector2d& point) const;

  /// The same if a face nearby is known, such as the answer for the point before: ten times as fast for
  /// points inside. If several faces share the place, the answer may be another of them.
  MapPlace onMap(const Eigen::RowVector2d& point, int nearFace) const;

  /// Builds the search tree of the surface, with progress. Otherwise the first onSurface() does.
  /// @throws InvalidInput if no face has an area on the surface.
  void prepareSurface(const ProgressCallback& progress) const;

  /// The place on the surface nearest to @p point in space; Distance is in space.
  /// @throws InvalidInput if it is not finite or no face has an area on the surface.
  MapPlace onSurface(const Eigen::RowVector3d& point) const;

  /// Where a place is on the surface, and in the plane.
  Eigen::RowVector3d surfacePoint(const MapPlace& place) const;
  Eigen::RowVector2d mapPoint(const MapPlace& place) const;

private:
  // The faces of a mesh that have an area, as only these can be searched, and their numbers in the mesh.
  struct Searched
  {
    Searched(TriangleMesh whole, const ProgressCallback& progress);
    MapPlace nearest(const Eigen::RowVector3d& point) const;

    TriangleMesh Mesh;
    std::vector<int> Faces;
    std::vector<int> NumberOf; // the inverse of Faces; -1 for a face without area
    double Diagonal;
    std::unique_ptr<ClosestPointTree> Projection;
  };

  TriangleMesh Surface;
  Points2 Positions;
  Searched Map;
  ClosestPointWalk MapWalk;
  mutable std::once_flag SpaceSearched; // most callers never search the surface
  mutable std::unique_ptr<Searched> Space;
};

} // namespace flattening
