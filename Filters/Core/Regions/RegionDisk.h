// SPDX-License-Identifier: GPL-3.0-or-later
/// Cutting a region out of a surface as a disk with a margin around it.
#pragma once

#include "Mesh/DerivedMesh.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

struct RegionDiskOptions
{
  double Margin = 0.0;       ///< width of the margin around the region (input units, >= 0)
  double LargestHoles = 0.1; ///< greatest area of all filled holes as a share of the region's, >= 0
};

struct RegionDisk
{
  DerivedMesh Disk;           ///< the region and its margin
  std::vector<char> InRegion; ///< one flag per face of the disk: 1 in the region, 0 in the margin
  int Pieces = 0;             ///< number of connected pieces of the region; only the largest is kept
  double DroppedArea = 0.0;   ///< area of the other pieces (input units squared)
  int FilledHoles = 0;        ///< number of holes that became a part of the region
  double FilledArea = 0.0;    ///< area of these holes (input units squared)
};

/// The largest connected piece of the region as a disk. Holes in it, which are faces of other regions,
/// become a part of it, and where it touches itself at a vertex, the faces around that vertex are added.
/// The margin has all faces whose three corners are within its width of the region. Distances are
/// measured along edges, which is up to 1.4 times as long as a geodesic.
/// @param inRegion one flag per face (m).
/// @throws InvalidInput if an option is out of range, the region is empty or covers a closed surface;
/// TopologyError, with the remedy, if the surface is not an oriented manifold, the holes are too large,
/// or the region or its margin closes around a part of the surface or has a handle.
RegionDisk regionDisk(const TriangleMesh& mesh,
  const std::vector<char>& inRegion,
  const RegionDiskOptions& options = {});

} // namespace flattening
