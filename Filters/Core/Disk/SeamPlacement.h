// SPDX-License-Identifier: GPL-3.0-or-later
/// The choice of a seam along which a closed surface is cut open.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// Two points for cutGeodesicSeam at extremities of a connected surface: the vertex farthest from an
/// arbitrary one, along edges, and the vertex farthest from that. A long seam flattens best, and a seam
/// removes no area. On a sphere the mean area distortion |Upsilon| of the conformal map is 0.7 with this
/// seam, 3.0 with a quarter of its length, and 5.0 with a hole of a thousandth of the area.
/// @param avoided one flag per vertex, not 0 where the seam may not be; empty: it may be anywhere. With
/// flags, the seam is the longest stretch off the region of these geodesics: between two extremities of
/// the part around the vertex farthest from the region, and from that vertex to either.
/// @throws InvalidInput if the flags are of another number than the vertices or leave no room.
std::vector<Eigen::Vector3d> placeSeam(const TriangleMesh& mesh,
  const std::vector<char>& avoided = {},
  const ProgressCallback& progress = {});

} // namespace flattening
