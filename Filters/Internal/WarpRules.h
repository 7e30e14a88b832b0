// SPDX-License-Identifier: GPL-3.0-or-later
/// What Planar Warp does with whatever lies on the mesh.
#pragma once

#include "Core/FlatMap/PlanarWarp.h"

#include <vtkType.h>

namespace flattening
{

/// Name of the array (unsigned char) that is 1 for what lies on the mesh.
inline constexpr const char* InMapName = "InMap";

struct WarpRules
{
  const PlanarWarp& Warp;
  bool RemoveOutside;    ///< or leave unmoved
  double MaximalSegment; ///< of lines; 0: they are not subdivided
  ProgressCallback Progress;
};

struct CarryCounts
{
  long long Outside = 0;
  long long Inserted = 0;
};

/// Points in space that are carried within the plane and keep their heights above it.
struct CarriedInSpace
{
  Points3 Positions;
  std::vector<char> Inside;
};

CarriedInSpace carryInSpace(const Points3& points, const WarpRules& rules);

/// Into how many parts of at most rules.MaximalSegment the segment between two points is divided, 1 or
/// more.
/// @throws InvalidInput if there are more than a million.
int segmentParts(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const WarpRules& rules);

/// @throws InvalidInput if nothing lies on the mesh; says where both are.
void requireSomeInside(const CarriedInSpace& carried, const Points3& points);

} // namespace flattening
