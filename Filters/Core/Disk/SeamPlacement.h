// SPDX-License-Identifier: GPL-3.0-or-later
/// Where to cut a closed surface open along a seam.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// The ends of a seam (for cutGeodesicSeam) between two ends of a connected surface: from the vertex
/// farthest from any, along edges, to the one farthest from that. So long a seam flattens best, and
/// nothing is lost in any length: on a sphere the mean area distortion |Upsilon| of the conformal map is
/// 0.7, with a quarter of the length 3.0, with a hole of a thousandth of the area 5.0.
/// @param avoided one flag per vertex, not 0 where the seam may not be; none: anywhere. The seam is then
/// the longest stretch that keeps off the region, of the geodesics between two ends of the part around
/// the vertex farthest from it and from that vertex to either.
/// @throws InvalidInput if the flags are of another number than the vertices or leave no room.
std::vector<Eigen::Vector3d> placeSeam(const TriangleMesh& mesh,
  const std::vector<char>& avoided = {},
  const ProgressCallback& progress = {});

} // namespace flattening
