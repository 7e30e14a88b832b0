// SPDX-License-Identifier: GPL-3.0-or-later
/// Puts the faces of a surface on a flat map, each at one bank of a seam.
#pragma once

#include "Base/Progress.h"
#include "FlatMap/FlatMapTransfer.h"
#include "FlatMap/SharedFaces.h"
#include "FlatMap/SurfaceBoundary.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/ClosestPointWalk.h"

namespace flattening
{

/// The search structures that find places on the flattened surface for points of the target.
struct PlaceSearch
{
  const ClosestPointTree& Tree;
  const ClosestPointWalk& Walk;
  const SurfaceBoundary& Boundary;
  const Points3& Normals; ///< of the target's vertices, on the side of those of the flattened surface
  const std::vector<SharedFace>& Shared; ///< of the target's faces with the flattened surface
  double SamePlace; ///< points that are not farther apart in space are the same, input units
};

/// Fills map.Part and what follows it, for the vertices that map.Survived and map.Places tell. A shared
/// face takes the positions that its corners have on the map. Without a seam, every other face whose
/// vertices survived takes their positions. With seams, such a face lies on the bank of its centroid. A
/// corner whose place is on that bank, or beyond no seam, keeps its place; one that lies on the seam
/// takes the position that the seam has on the bank; a face that has a corner beyond the seam is left
/// out.
void placeFaces(const FlattenedSurface& flattened,
  const TriangleMesh& target,
  const PlaceSearch& search,
  TransferredMap& map,
  const ProgressCallback& progress = {});

} // namespace flattening
