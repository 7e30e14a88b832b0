// SPDX-License-Identifier: GPL-3.0-or-later
/// From any set of triangles to an oriented manifold surface.
#pragma once

#include "DerivedMesh.h"

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
  DerivedMesh Surface; ///< oriented manifold, possibly of several components
  /// Per face: turned over against the input to agree with its neighbours.
  std::vector<char> Reversed;
  /// Per face: beside an edge at which the surface had to be cut because it is one-sided.
  std::vector<char> OneSided;
  RepairReport Report;
};

/// Merges coincident points (see coincidentPoints for @p tolerance), drops degenerate and duplicate
/// faces, orients neighbours alike and, where more than two faces share an edge or fans of faces meet in
/// one vertex only, cuts the surface into its sheets by copying vertices (Gueziec, Taubin, Lazarus, Horn
/// 2001, "Cutting and stitching", as in CGAL's orient_polygon_soup).
///
/// A face is degenerate if its altitude is below 1e-12 of its longest edge. It leaves no crack: the face
/// beyond its longest edge is split at the vertex between.
/// @throws InvalidInput if there is no face, a vertex in use is not finite, or no face has an area.
RepairedSurface repairTriangleSoup(const TriangleMesh& soup, double tolerance = 0.0);

/// Turns all faces of a connected oriented surface over if that is nearer to what the user meant: a
/// closed one gets its normals outward, an open one keeps the sides that the larger area had.
/// @p reversed as in RepairedSurface. Returns the number of faces turned over against the input.
int orientOutward(TriangleMesh& component, const std::vector<char>& reversed, bool closed);

} // namespace flattening
