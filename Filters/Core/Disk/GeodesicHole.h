// SPDX-License-Identifier: GPL-3.0-or-later
/// Opens a closed surface by a small round hole.
#pragma once

#include "Base/Progress.h"
#include "Mesh/DerivedMesh.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace flattening
{

struct GeodesicHoleOptions
{
  /// The point of the surface nearest to it becomes the hole's centre (input units; see pickOnSurface);
  /// if absent, geodesicCentre chooses.
  std::optional<Eigen::Vector3d> Centre;
  /// One flag per vertex of the surface: a hole that geodesicCentre places keeps off the vertices that
  /// are not 0, if there is room for it anywhere else. Empty: no vertex is to be avoided.
  std::vector<char> Avoided;
  /// Area of the hole as share of the surface's area, in (0, 0.5].
  double AreaFraction = 1e-3;
  /// The hole's boundary gets at least as many vertices (>= 3), whatever the mesh.
  int BoundaryVertices = 128;
};

struct OpenedSurface
{
  DerivedMesh Surface; ///< of the same genus; a disk if that is 0
  Eigen::Vector3d Centre = Eigen::Vector3d::Zero();
  double Radius = 0.0;      ///< geodesic, input units
  double RemovedArea = 0.0; ///< input units squared
  int RemovedAvoided = 0;   ///< vertices of the region to be avoided that had to go all the same
};

/// Cuts a geodesic disk out of @p closed. The mesh is first refined around the hole by longest-edge
/// bisection, which leaves the surface as it is; the distance from the centre is that of the heat method
/// on the intrinsic Delaunay triangulation (Crane, Weischedel, Wardetzky 2013; CGAL Heat_method_3); the
/// cut follows the level curve that encloses the wanted area. Parts of the surface that the curve cuts
/// off from the rest, as happens between folds, go with the hole. Vertices nearer to the curve than a
/// fraction of their edges move onto it, and curve points too close to each other become one, so that no
/// slivers remain at the cut.
/// @throws InvalidInput if an option is out of range or the centre is off the surface; TopologyError if
/// the surface is not closed and connected, or no round hole of that size can be cut, for instance
/// because it would reach around a handle.
OpenedSurface cutGeodesicHole(const TriangleMesh& closed,
  const GeodesicHoleOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
