// SPDX-License-Identifier: GPL-3.0-or-later
/// Opens a closed surface by a small round hole, a geodesic disk.
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
  /// A point in space; the point of the surface nearest to it becomes the hole's centre (input units,
  /// see pickOnSurface). If absent, geodesicCentre chooses.
  std::optional<Eigen::Vector3d> Centre;
  /// One flag per vertex of the surface: a hole that geodesicCentre places keeps off the vertices whose
  /// flag is not 0, if there is room for it elsewhere. Empty: the hole may be anywhere.
  std::vector<char> Avoided;
  /// The area of the hole as a share of the surface's area, in (0, 0.5].
  double AreaFraction = 1e-3;
  /// The least number of vertices of the hole's boundary (>= 3), whatever the mesh.
  int BoundaryVertices = 128;
};

struct OpenedSurface
{
  DerivedMesh Surface; ///< of the same genus; a disk if that is 0
  Eigen::Vector3d Centre = Eigen::Vector3d::Zero();
  double Radius = 0.0;      ///< geodesic, input units
  double RemovedArea = 0.0; ///< input units squared
  int RemovedAvoided = 0;   ///< vertices to be avoided that the hole took all the same
};

/// Cuts a geodesic disk out of @p closed. The mesh is first refined around the hole by longest-edge
/// bisection, which leaves the surface as it is. The distance from the centre is measured by the heat
/// method (geodesicDistances), and the cut follows the isoline of the distance that encloses the wanted
/// area. Parts of the surface that the isoline separates from the rest, as happens between folds, are
/// removed with the hole. Vertices near to the cut move onto it and its short edges are collapsed
/// (conditionBoundary), so that no slivers are left.
/// @throws InvalidInput if an option is out of range or the centre is off the surface; TopologyError if
/// the surface is not closed and connected, or no round hole of that size can be cut, for instance
/// because it would reach around a handle; Cancelled.
OpenedSurface cutGeodesicHole(const TriangleMesh& closed,
  const GeodesicHoleOptions& options = {},
  const ProgressCallback& progress = {});

} // namespace flattening
