// SPDX-License-Identifier: GPL-3.0-or-later
/// An oriented manifold from faces that may be oriented at random and meet in any way.
#pragma once

#include "Mesh/DerivedMesh.h"

#include <vector>

namespace flattening
{

struct OrientedMesh
{
  TriangleMesh Mesh;          ///< the faces in their order; copies of vertices come last
  std::vector<int> CopyOf;    ///< per vertex: the input vertex that it is, or is a copy of
  std::vector<char> Reversed; ///< per face: whether it was reversed to agree with its neighbours
  /// Per face: whether it is beside an edge at which the surface was cut because it is one-sided.
  std::vector<char> OneSided;
};

/// Makes an oriented manifold: reverses faces to agree with their neighbours and cuts the surface into
/// sheets by copying vertices where more than two faces share an edge, where fans of faces meet only in
/// a vertex, and where no orientation suits (Gueziec, Taubin, Lazarus, Horn 2001, "Cutting and
/// stitching"; CGAL orient_polygon_soup). No face may repeat a vertex, no two faces may have the same
/// three.
OrientedMesh orientConsistently(const TriangleMesh& mesh);

/// Sews border edges together that coincide point for point and run against each other, where that gives
/// a manifold (CGAL stitch_borders): closes the slits that cutting at non-manifold edges leaves. The
/// faces stay, in their order.
DerivedMesh stitchCoincidentBorders(const TriangleMesh& mesh);

/// Reverses all faces of a connected oriented surface if that is more likely what the user meant: the
/// normals of a closed surface point outward, an open surface keeps the sides that the larger area had.
/// @param reversed as in OrientedMesh.
/// @returns the number of faces reversed against the input.
int orientOutward(TriangleMesh& component, const std::vector<char>& reversed, bool closed);

} // namespace flattening
