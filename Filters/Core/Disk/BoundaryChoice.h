// SPDX-License-Identifier: GPL-3.0-or-later
/// Which boundary loop of a surface becomes that of the disk.
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

/// The number of the chosen loop (loops as in MeshTopology), -1 for none. Equal ones: the first.
/// @throws InvalidInput if the point is not finite.
int chooseBoundary(const Points3& vertices,
  const std::vector<std::vector<int>>& loops,
  const BoundaryChoice& choice);

/// Whether a loop is shorter than a circle around this share of the area of the surface: a defect or a
/// puncture, of too few edges to become the boundary of the flat disk.
bool isPuncture(const TriangleMesh& mesh, const std::vector<int>& loop, double areaFraction);

/// Mean of the loop's vertices.
Eigen::Vector3d centreOfLoop(const Points3& vertices, const std::vector<int>& loop);

} // namespace flattening
