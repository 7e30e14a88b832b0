// SPDX-License-Identifier: GPL-3.0-or-later
/// The rules by which Planar Warp moves points, and checks that all kinds of data share.
#pragma once

#include "Core/FlatMap/PlanarWarp.h"

#include <vtkType.h>

namespace flattening
{

/// Name of the array (unsigned char) that is 1 where a point lies on the mesh, else 0.
inline constexpr const char* InMapName = "InMap";

struct WarpRules
{
  const PlanarWarp& Warp;
  bool RemoveOutside;    ///< whether points outside the mesh are removed; else they stay unmoved
  double MaximalSegment; ///< greatest length of a segment of a line (input units); 0: no limit
  ProgressCallback Progress;
};

struct WarpCounts
{
  long long Outside = 0;  ///< number of points or pixels outside the mesh
  long long Inserted = 0; ///< number of points inserted on lines
};

/// Points in space (n x 3) that move within the plane and keep their heights above it.
struct WarpedInSpace
{
  Points3 Positions;
  std::vector<char> Inside;
};

WarpedInSpace warpInSpace(const Points3& points, const WarpRules& rules);

/// The number of equal parts, of at most rules.MaximalSegment each, into which the segment between two
/// points is divided; at least 1.
/// @throws InvalidInput if it is more than a million.
int segmentParts(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const WarpRules& rules);

/// Checks the number of points that are inserted on all lines together.
/// @throws InvalidInput if it is more than 20 million.
void requireRoomFor(long long inserted);

/// Checks that a point lies on the mesh.
/// @throws InvalidInput if none does; the message tells where the data are.
void requireSomeInside(const WarpedInSpace& warped, const Points3& points);

} // namespace flattening
