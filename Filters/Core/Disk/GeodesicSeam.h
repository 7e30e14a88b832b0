// SPDX-License-Identifier: GPL-3.0-or-later
/// Opens a surface along geodesics through given points; nothing is removed.
#pragma once

#include "Base/Progress.h"
#include "Disk/EdgeCut.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

struct GeodesicSeamOptions
{
  /// Two or more points on the surface in the order in which the seam runs through them (input units).
  std::vector<Eigen::Vector3d> Points;
  /// The least number of vertices of the disk's boundary (>= 3), whatever the mesh.
  int BoundaryVertices = 128;
};

struct SeamOpenedSurface
{
  /// Of the same genus. It is a disk if that is 0 and the surface was closed, or a tube cut from end to
  /// end.
  CutSurface Cut;
  /// The points asked for, moved onto the surface.
  std::vector<Eigen::Vector3d> Points;
  double Length = 0.0; ///< of the seam, input units
};

/// Opens a closed surface along the exact geodesics (geodesicPath) between consecutive points. A surface
/// with boundary is cut from its boundary inwards: the first or the last point must lie on the boundary
/// or not farther from it than the edges there, and moves onto it. If both do, on different loops, the
/// seam runs from one loop to the other.
///
/// The geodesics are cut into the faces, which keep their areas and their planes. Where the seam passes
/// a vertex closer than a fraction of the edge it goes through the vertex, and the parts of a face are
/// triangulated for the largest angles. Where the seam would cross too few edges the mesh is refined
/// first by longest-edge bisection. New vertices are made of the ends of the edge that they split.
/// @throws InvalidInput if there are fewer than two points, or points coincide (to a millionth of the
/// surface's size) or lie off the surface (pickOnSurface); TopologyError if the surface is not
/// connected, or the seam crosses or touches itself or the boundary; Cancelled.
SeamOpenedSurface cutGeodesicSeam(const TriangleMesh& mesh,
  const GeodesicSeamOptions& options,
  const ProgressCallback& progress = {});

} // namespace flattening
