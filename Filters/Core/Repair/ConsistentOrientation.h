// SPDX-License-Identifier: GPL-3.0-or-later
/// Faces that agree on which side is which.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

struct OrientedMesh
{
  TriangleMesh Mesh; ///< the faces in their order; copies of vertices come last
  /// Per vertex: the input vertex that it is, or is a copy of.
  std::vector<int> CopyOf;
  /// Per face: turned over to agree with its neighbours.
  std::vector<char> Reversed;
  /// Per face: beside an edge at which the surface had to be cut because it is one-sided.
  std::vector<char> OneSided;
};

/// Makes an oriented manifold: turns faces over to agree with their neighbours and, where more than two
/// faces share an edge, fans of faces meet in one vertex only, or no orientation suits, cuts the surface
/// into sheets by copying vertices (Gueziec, Taubin, Lazarus, Horn 2001, "Cutting and stitching"; CGAL
/// orient_polygon_soup). No face may repeat a vertex, no two faces may have the same three.
OrientedMesh orientConsistently(const TriangleMesh& mesh);

/// Turns all faces of a connected oriented surface over if that is nearer to what the user meant: a
/// closed one gets its normals outward, an open one keeps the sides that the larger area had.
/// @p reversed as in OrientedMesh. Returns the number of faces turned over against the input.
int orientOutward(TriangleMesh& component, const std::vector<char>& reversed, bool closed);

} // namespace flattening
