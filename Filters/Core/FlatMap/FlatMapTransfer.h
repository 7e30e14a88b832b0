// SPDX-License-Identifier: GPL-3.0-or-later
/// Transfer of a flat map to another triangulation of the same surface.
#pragma once

#include "Base/Progress.h"
#include "Mesh/ClosestPointTree.h"
#include "Mesh/DerivedMesh.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

struct FlattenedSurface
{
  TriangleMesh Surface; ///< in space, an oriented manifold
  Points2 Positions;    ///< n x 2, flat positions of its vertices
};

struct TransferredMap
{
  Points2 Positions;                ///< flat position of each vertex of the target; 0 if lost
  std::vector<char> Survived;       ///< one flag per vertex of the target
  std::vector<SurfacePoint> Places; ///< nearest points on the flattened surface; undefined if lost
  double Tolerance = 0.0;           ///< the tolerance that was used, input units
  double LargestDistance = 0.0;     ///< greatest distance of a survivor from its place, input units

  DerivedMesh Part;         ///< the faces that lie on the map; vertices on a seam once for each bank
  Points2 PartPositions;    ///< flat position of each vertex of Part
  int KeptVertices = 0;     ///< vertices of the target that Part has
  int RepeatedVertices = 0; ///< vertices of the target that Part has more than once
  int FacesAcrossSeams = 0; ///< faces left out because a seam runs through them
};

/// Gives every vertex of @p target, e.g. the surface before it was repaired and remeshed, the flat
/// position of the nearest point on the flattened surface, with barycentric weights. That point is
/// rejected if it is farther away than @p tolerance, if the normals differ by more than 90 degrees (the
/// other side of a fold), or if the vertex lies beyond the boundary of the flattened surface (over a
/// hole or a part that was cut off). Then the nearest point is searched again by walking over the
/// flattened surface from the places of the neighbours of the vertex; if that fails, too, the vertex is
/// lost. The whole target may be oriented opposite to the flattened surface.
///
/// The flattened surface may have been cut open along seams, whose banks lie at the same place in space
/// (SurfaceBoundary). A face then lies on the bank of its centroid, and takes the positions that its
/// corners have there; a face through which a seam runs has no place in one piece and is left out. A
/// face is also left out if one of its vertices is lost.
/// @param tolerance greatest distance, input units, >= 0; 0: half of the mean edge length of the
/// flattened surface.
/// @throws InvalidInput if a coordinate is not finite, the sizes do not fit, or no vertex survives.
TransferredMap transferFlatMap(const FlattenedSurface& flattened,
  const TriangleMesh& target,
  double tolerance = 0.0,
  const ProgressCallback& progress = {});

} // namespace flattening
