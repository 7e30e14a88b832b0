// SPDX-License-Identifier: GPL-3.0-or-later
/// Opens a surface along a tree of geodesics that join given tips; nothing is removed.
#pragma once

#include "Base/Progress.h"
#include "Disk/SeamInsertion.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

struct ReliefOpenedSurface
{
  SeamOpenedSurface Opened;
  int Branches = 0; ///< number of branches that were cut; without one the surface is as it was
};

/// Joins one tip after the other to the boundary and the branches before it by the geodesic from the
/// tip to the nearest of their vertices (along edges), as far as the first place where it meets them;
/// the first tip of a closed surface is joined to by the second. The geodesics are cut into the faces as
/// cutGeodesicSeam does. A tip gets no branch if a branch before it comes nearer to it than 0.02 square
/// roots of the surface's area, or if no free path leads to it.
/// @param mesh  connected, with one boundary or none
/// @param tips  points on the surface or near it, as placeRelief finds them; the nearest vertices are
///        joined
/// @param avoided  one flag per vertex, not 0 where no branch may run; empty: branches may run anywhere.
///        Branches keep a distance from the flagged vertices where there is room.
/// @throws Cancelled.
ReliefOpenedSurface cutRelief(const TriangleMesh& mesh,
  const std::vector<Eigen::Vector3d>& tips,
  const std::vector<char>& avoided = {},
  const ProgressCallback& progress = {});

} // namespace flattening
