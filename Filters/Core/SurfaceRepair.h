// SPDX-License-Identifier: GPL-3.0-or-later
/// From any set of triangles to an oriented manifold surface.
#pragma once

#include "DerivedMesh.h"

#include <vector>

namespace flattening
{

/// What repairTriangleSoup changed.
struct RepairReport
{
  int MergedPoints = 0;    ///< points joined to a coincident one
  int UnusedPoints = 0;    ///< points of no triangle
  int DegenerateFaces = 0; ///< dropped: a repeated vertex, or corners on one line
  int DuplicateFaces = 0;  ///< dropped: the same three vertices as an earlier face
  int SplitPoints = 0;     ///< copies of vertices that cut the surface apart where it was not manifold
};

struct RepairedSurface
{
  DerivedMesh Surface;        ///< oriented manifold, possibly of several components
  std::vector<char> Reversed; ///< per face, see OrientedMesh
  std::vector<char> OneSided; ///< per face, see OrientedMesh
  RepairReport Report;
};

/// Merges coincident points (see coincidentPoints for @p tolerance), drops degenerate and duplicate
/// faces, and makes the rest an oriented manifold (orientConsistently).
///
/// A face is degenerate if its altitude is below 1e-12 of its longest edge. It leaves no crack: the face
/// beyond its longest edge is split at the vertex between.
/// @throws InvalidInput if there is no face, a vertex in use is not finite, or no face has an area.
RepairedSurface repairTriangleSoup(const TriangleMesh& soup, double tolerance = 0.0);

} // namespace flattening
