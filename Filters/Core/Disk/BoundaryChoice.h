// SPDX-License-Identifier: GPL-3.0-or-later
/// The choice of the boundary loop of a surface that becomes the boundary of the disk.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

struct BoundaryChoice
{
  enum class Rule
  {
    Longest,
    ClosestToPoint,
    None ///< all loops are filled
  };
  Rule By = Rule::Longest;
  Eigen::Vector3d Point = Eigen::Vector3d::Zero(); ///< for ClosestToPoint, input units
};

/// The number of the chosen loop (loops as in MeshTopology), the first one if several are equal; -1 for
/// none.
/// @throws InvalidInput if the point is not finite.
int chooseBoundary(const Points3& vertices,
  const std::vector<std::vector<int>>& loops,
  const BoundaryChoice& choice);

/// The length of the longest loop that is filled unless a limit is asked for, input units.
double longestFilledUnasked(const TriangleMesh& mesh);

/// Whether a loop is a puncture: shorter than a circle around the share @p areaFraction (0 to 1) of the
/// surface's area, and no longer than @p longestFilled (input units). So short a loop has too few edges to
/// become the boundary of the flat disk.
bool isPuncture(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  double areaFraction,
  double longestFilled);

/// The mean of the loop's vertices, input units.
Eigen::Vector3d centreOfLoop(const Points3& vertices, const std::vector<int>& loop);

} // namespace flattening
