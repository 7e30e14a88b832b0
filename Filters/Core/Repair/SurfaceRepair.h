// SPDX-License-Identifier: GPL-3.0-or-later
/// From any set of triangles to an oriented manifold surface.
#pragma once

#include "Mesh/DerivedMesh.h"

#include <vector>

namespace flattening
{

/// What repairTriangleSoup changed.
struct RepairReport
{
  int MergedPoints = 0;    ///< points joined to one that coincides, all but or within the tolerance
  int UnusedPoints = 0;    ///< points of no triangle
  int DegenerateFaces = 0; ///< dropped: a repeated vertex, or corners on one line
  int DuplicateFaces = 0;  ///< dropped: the same three vertices as an earlier face
  int ClosedCracks = 0;    ///< places where an open edge was split at a point that lies on it
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
/// faces, closes cracks without width (closeCracks), and makes the rest an oriented manifold
/// (orientConsistently).
///
/// A face is degenerate if an edge is shorter than 1e-9 of another, which is collapsed
/// (collapseNeedles), or if its altitude is below 1e-10 of its longest edge. The latter leaves no crack:
/// the face beyond its longest edge is split at the vertex between (dissolveCollinearFaces).
/// @throws InvalidInput if there is no face, a vertex in use is not finite, or no face has an area.
RepairedSurface repairTriangleSoup(const TriangleMesh& soup, double tolerance = 0.0);

} // namespace flattening
