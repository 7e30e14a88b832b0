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

/// Calls @p visit(first, count) for each edge whose sides begin at a number in [begin, end): its sides
/// are first[0] to first[count - 1].
template <typename Visit>
void forEachEdge(const std::vector<FaceSide>& sortedSides,
  std::size_t begin,
  std::size_t end,
  const Visit& visit)
{
  const auto continues = [&sortedSides](std::size_t i)
  { return i < sortedSides.size() && sortedSides[i].edge() == sortedSides[i - 1].edge(); };
  while (begin > 0 && continues(begin))
  {
    ++begin;
  }
  for (std::size_t next = begin; begin < end; begin = next)
  {
    do
    {
      ++next;
    } while (continues(next));
    visit(&sortedSides[begin], static_cast<int>(next - begin));
  }
}

/// The same for all edges.
template <typename Visit>
void forEachEdge(const std::vector<FaceSide>& sortedSides, const Visit& visit)
{
  forEachEdge(sortedSides, 0, sortedSides.size(), visit);
}

/// The half-edge on the other side of each; -1 at the boundary, and where an edge does not join exactly
/// two faces of one orientation.
std::vector<int> oppositeHalfedges(const FaceMatrix& faces);
/// The same for the sides of all faces, sorted as by sortedSides().
std::vector<int> oppositeHalfedges(const std::vector<FaceSide>& sides);

/// The vertices, in ascending order, whose faces are several fans: a fan is faces that follow each other
/// across edges which join two faces of one orientation.
/// @param opposite  as from oppositeHalfedges(); the vertices are 0 to @p vertexCount - 1.
std::vector<int> verticesOfSeveralFans(const FaceMatrix& faces,
  const std::vector<int>& opposite,
  int vertexCount);

} // namespace flattening
