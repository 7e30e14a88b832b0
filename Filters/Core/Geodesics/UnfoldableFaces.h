// SPDX-License-Identifier: GPL-3.0-or-later
/// The faces of a surface, each with what is needed to unfold it into the plane of a neighbour.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Whether paths cross edges of the boundary that lie on each other, as those on both banks of a seam
/// do.
enum class Seams
{
  Open,  ///< no path crosses them
  Closed ///< paths cross them as they cross all other edges
};

/// A half-edge in the plane of its face: it begins at the origin and runs along the x-axis; the third
/// corner of the face, its apex, lies above. Input units.
struct PlanarSide
{
  double Length = 0.0;
  double ApexX = 0.0;
  double ApexY = 0.0;
};

/// The faces of a surface of triangles, joined along their half-edges (see Mesh/Halfedges.h). Where
/// seams are closed, the copies of a vertex on their banks are one place; other vertices are a place
/// each.
struct UnfoldableFaces
{
  UnfoldableFaces(const TriangleMesh& mesh, Seams seams);

  int placeCount() const { return static_cast<int>(this->CornerStarts.size()) - 1; }
  int halfedgeCount() const { return static_cast<int>(this->Sides.size()); }

  std::vector<int> PlaceOf;      ///< of every vertex of the mesh
  std::vector<int> Origin;       ///< the place where each half-edge begins
  std::vector<int> Opposite;     ///< the half-edge on the other side; -1 where paths do not cross
  std::vector<PlanarSide> Sides; ///< of every half-edge
  /// The half-edges that begin at place p: Corners[CornerStarts[p]] up to before CornerStarts[p + 1].
  std::vector<int> CornerStarts;
  std::vector<int> Corners;
  std::vector<char> Bends;     ///< 1 at places where a shortest path may bend
  double MeanLength = 0.0;     ///< of the half-edges
  bool HasClosedSeams = false; ///< whether edges of the boundary were joined
};

} // namespace flattening
