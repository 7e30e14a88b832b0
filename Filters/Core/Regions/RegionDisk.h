// SPDX-License-Identifier: GPL-3.0-or-later
/// A region of a surface as a disk, with a margin around it.
#pragma once

#include "Mesh/DerivedMesh.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

struct RegionDiskOptions
{
  double Margin = 0.0;       ///< width of what is taken along around the region (input units, >= 0)
  double LargestHoles = 0.1; ///< area of all holes that are filled, as share of the region's, >= 0
};

struct RegionDisk
{
  DerivedMesh Disk;           ///< the region and its margin
  std::vector<char> InRegion; ///< per face of it: not 0 in the region
  int Pieces = 0;             ///< of the region; only the largest is kept
  double DroppedArea = 0.0;   ///< of the other pieces (input units squared)
  int FilledHoles = 0;        ///< that became a part of the region
  double FilledArea = 0.0;    ///< of them
};

/// The largest connected piece of the region (flags per face) as a disk: holes in it, faces of other
/// regions, are filled with the surface that is there, and where it touches itself at a vertex, the
/// faces around that vertex are added. The margin has all faces whose corners are as near to the region
/// along edges, which are up to 1.4 times as long as a geodesic.
/// @throws InvalidInput if an option is out of range, the region is empty or covers a closed surface;
/// TopologyError, with the remedy, if the surface is not an oriented manifold, the holes are too large,
/// or the region or its margin closes around a part of the surface or has a handle.
RegionDisk regionDisk(const TriangleMesh& mesh,
  const std::vector<char>& inRegion,
  const RegionDiskOptions& options = {});

} // namespace flattening
