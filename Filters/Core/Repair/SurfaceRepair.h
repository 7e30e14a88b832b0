// SPDX-License-Identifier: GPL-3.0-or-later
/// From any set of triangles to an oriented manifold surface.
#pragma once

#include "Mesh/DerivedMesh.h"

#include <vector>

namespace flattening
{

/// The changes that repairTriangleSoup made.
struct RepairReport
{
  int MergedPoints = 0;     ///< points joined to another one within the tolerance or by a needle
  int UnusedPoints = 0;     ///< points of no triangle
  int DegenerateFaces = 0;  ///< dropped: faces that repeat a vertex, needles and caps
  int DuplicateFaces = 0;   ///< dropped: faces with the same three vertices as an earlier one
  int ClosedTJunctions = 0; ///< places where an open edge was split at a point on it
  int SplitPoints = 0;      ///< copies of vertices that cut the surface apart where it was not manifold
};

struct RepairedSurface
{
  DerivedMesh Surface;        ///< oriented manifold, possibly of several components
  std::vector<char> Reversed; ///< per face, see OrientedMesh
  std::vector<char> OneSided; ///< per face, see OrientedMesh
  RepairReport Report;
};

/// @throws InvalidInput if there is no face, or a face names a vertex that does not exist or is not
/// finite.
void requireUsableFaces(const TriangleMesh& soup);

/// Merges coincident points (see coincidentPoints for @p tolerance, in input units), removes needles and
/// caps (removeNeedlesAndCaps) and duplicate faces, closes T-junctions (closeTJunctions), and makes the
/// rest an oriented manifold (orientConsistently).
/// @param keptApart  one flag per point: not 0 where it is not merged with points that coincide with it,
/// as on the banks of a seam; empty: every point may be merged. If all points are kept apart, no
/// T-junction is closed either.
/// @throws InvalidInput as requireUsableFaces does, and if no face has an area.
RepairedSurface repairTriangleSoup(const TriangleMesh& soup,
  double tolerance = 0.0,
  const std::vector<char>& keptApart = {});

} // namespace flattening
