// SPDX-License-Identifier: GPL-3.0-or-later
/// Opens a surface along geodesics through given points; nothing is removed.
#pragma once

#include "Base/Progress.h"
#include "Disk/SeamInsertion.h"
#include "Disk/SeamWayPoints.h"
#include "Mesh/TriangleMesh.h"

namespace flattening
{

/// Opens a closed surface along the exact geodesics (geodesicPath) between consecutive points of each
/// path. Several paths form a tree: a path may begin and end on one before it, or not farther from it
/// than the edges there, or share a point with it. A surface with boundary is cut from its boundary
/// inwards: the first or the last point of a path must lie on the boundary or not farther from it than
/// the edges there, and moves onto it. If both do, on different loops, the seam runs from one loop to
/// the other.
///
/// The geodesics are cut into the faces, which keep their areas and their planes. Where the seam passes
/// a vertex closer than a fraction of the edge it goes through the vertex, and the parts of a face are
/// triangulated for the largest angles. Where the seam would cross too few edges the mesh is refined
/// first by longest-edge bisection. New vertices are made of the ends of the edge that they split.
/// @throws InvalidInput if there are fewer than two points on a path, or points coincide (to a millionth
/// of the surface's size) or lie off the surface (pickOnSurface); TopologyError if the surface is not
/// connected, paths cross, close a loop or do not meet, or a path touches itself or the boundary;
/// Cancelled.
SeamOpenedSurface cutGeodesicSeam(const TriangleMesh& mesh,
  const GeodesicSeamOptions& options,
  const ProgressCallback& progress = {});

} // namespace flattening
