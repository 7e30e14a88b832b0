// SPDX-License-Identifier: GPL-3.0-or-later
/// The points that a user gives for a seam, as vertices of the surface.
#pragma once

#include "Base/Progress.h"
#include "Disk/SeamInsertion.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// The greatest number of points, and of paths, that a user may set for a seam: a guard for memory.
constexpr int MostSeamPoints = 100'000;

struct GeodesicSeamOptions
{
  /// Two or more points on the surface in the order in which the seam runs through them (input units).
  std::vector<Eigen::Vector3d> Points;
  /// The least number of vertices of the disk's boundary (>= 3), whatever the mesh.
  int BoundaryVertices = 128;
  /// The numbers (from 0) of the points with which a further path begins, in ascending order: no seam
  /// runs from the point before to such a point. Empty: all points are on one path.
  std::vector<int> PathStarts;
  /// Whether the points are those of polylines, which may lie much closer to each other than the edges
  /// of the mesh are long: points closer than that are left out, except for ends of paths.
  bool AreDense = false;
};

/// The points from number Begin to before number End are on one path.
struct SeamPath
{
  std::size_t Begin;
  std::size_t End;
};

struct SeamWayPoints
{
  std::vector<SeamPath> Paths;
  std::vector<SeamInsertion::Vertex> Vertices; ///< of all paths, one after the other
  std::vector<std::size_t> OnBoundary;         ///< numbers of the points on the boundary: ends of paths

  bool isOnBoundary(std::size_t point) const;
  /// The numbers of the points from which a leg leads to the next point.
  std::vector<std::size_t> legs() const;
};

/// Makes the points vertices, in faces small enough for seams of @p edgesWanted edges together. Ends of
/// paths near the boundary move onto it. Reports for each point.
/// @param original  the mesh of the seams before anything is inserted, with its topology
/// @throws as cutGeodesicSeam for points that make no seam; Cancelled.
SeamWayPoints insertWayPoints(SeamInsertion& seams,
  const TriangleMesh& original,
  const MeshTopology& topology,
  const GeodesicSeamOptions& options,
  std::size_t edgesWanted,
  const ProgressCallback& progress = {});

} // namespace flattening
