// SPDX-License-Identifier: GPL-3.0-or-later
/// The sides of all faces of a mesh, those of an edge next to each other.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace flattening
{

/// A side of a face, directed as the face is.
struct FaceSide
{
  int From;
  int To;
  int Halfedge; ///< 3 * face + corner, the corner being where the side begins

  int face() const { return this->Halfedge / 3; }
  /// The vertices of the edge, the smaller one first.
  std::pair<int, int> edge() const { return std::minmax({ this->From, this->To }); }
};

/// The sides of all @p faces, whose vertex numbers are >= 0, sorted by edge and then by half-edge.
std::vector<FaceSide> sortedSides(const FaceMatrix& faces);

/// Calls @p visit(first, count) for each edge: its sides are first[0] to first[count - 1].
template <typename Visit>
void forEachEdge(const std::vector<FaceSide>& sortedSides, const Visit& visit)
{
  for (std::size_t begin = 0, end = 0; begin < sortedSides.size(); begin = end)
  {
    while (end < sortedSides.size() && sortedSides[end].edge() == sortedSides[begin].edge())
    {
      ++end;
    }
    visit(&sortedSides[begin], static_cast<int>(end - begin));
  }
}

/// The half-edge on the other side of each; -1 at the boundary, and where an edge does not join exactly
/// two faces of one orientation.
std::vector<int> oppositeHalfedges(const FaceMatrix& faces);
/// The same for the sides of all faces, sorted as by sortedSides().
std::vector<int> oppositeHalfedges(const std::vector<FaceSide>& sides);

/// The vertices, in ascending order, whose faces are several fans: a fan is faces that follow each other
/// across edges which join two faces of one orientation.
/// @param sides of all faces, sorted as by sortedSides(); the vertices are 0 to @p vertexCount - 1.
std::vector<int> verticesOfSeveralFans(const std::vector<FaceSide>& sides, int vertexCount);

} // namespace flattening
