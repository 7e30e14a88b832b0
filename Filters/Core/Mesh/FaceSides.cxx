// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/FaceSides.h"

#include "Mesh/Halfedges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace flattening
{
namespace
{

// Vertices whose sides one task sorts: enough to outweigh the cost of a task. Results do not depend on
// it.
constexpr int VerticesPerTask = 4096;

template <typename Visit>
void forEachSide(const FaceMatrix& faces, const Visit& visit)
{
  const int* corner = faces.data();
  for (int h = 0; h < static_cast<int>(faces.size()); h += 3)
  {
    visit(FaceSide{ corner[h], corner[h + 1], h });
    visit(FaceSide{ corner[h + 1], corner[h + 2], h + 1 });
    visit(FaceSide{ corner[h + 2], corner[h], h + 2 });
  }
}

} // namespace

std::vector<FaceSide> sortedSides(const FaceMatrix& faces)
{
  // The sides are counted by their smaller vertex first, so that only a few have to be sorted at a time.
  const int vertices = faces.size() == 0 ? 0 : faces.maxCoeff() + 1;
  std::vector<int> first(vertices + 1, 0);
  forEachSide(faces, [&first](const FaceSide& side) { ++first[std::min(side.From, side.To) + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<FaceSide> sides(faces.size());
  std::vector<int> next(first.begin(), first.end() - 1);
  forEachSide(faces, [&](const FaceSide& side) { sides[next[std::min(side.From, side.To)]++] = side; });
  const auto isBefore = [](const FaceSide& a, const FaceSide& b)
  {
    const int greaterA = std::max(a.From, a.To);
    const int greaterB = std::max(b.From, b.To);
    return greaterA != greaterB ? greaterA < greaterB : a.Halfedge < b.Halfedge;
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, vertices, VerticesPerTask),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int v = range.begin(); v < range.end(); ++v)
      {
        std::sort(sides.begin() + first[v], sides.begin() + first[v + 1], isBefore);
      }
    });
  return sides;
}

std::vector<int> oppositeHalfedges(const std::vector<FaceSide>& sides)
{
  std::vector<int> opposite(sides.size(), -1);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sides.size(), HalfedgesPerTask),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      forEachEdge(sides,
        range.begin(),
        range.end(),
        [&opposite](const FaceSide* side, int count)
        {
          if (count == 2 && side[0].From == side[1].To && side[0].From != side[0].To)
          {
            opposite[side[0].Halfedge] = side[1].Halfedge;
            opposite[side[1].Halfedge] = side[0].Halfedge;
          }
        });
    });
  return opposite;
}

std::vector<int> oppositeHalfedges(const FaceMatrix& faces)
{
  return oppositeHalfedges(sortedSides(faces));
}

// A walk around a vertex, from an end of a fan if there is one, meets all of its faces if they are one
// fan.
std::vector<int> verticesOfSeveralFans(const FaceMatrix& faces,
  const std::vector<int>& opposite,
  int vertexCount)
{
  std::vector<int> sides(vertexCount, 0); // that begin at the vertex
  std::vector<int> first(vertexCount, -1);
  for (int h = 0; h < static_cast<int>(faces.size()); ++h)
  {
    const int v = faces.data()[h];
    ++sides[v];
    if (first[v] < 0 || opposite[h] < 0)
    {
      first[v] = h;
    }
  }
  std::vector<char> hasSeveral(vertexCount, 0);
  tbb::parallel_for(0,
    vertexCount,
    [&](int v)
    {
      int left = sides[v];
      for (int h = first[v]; h >= 0; h = opposite[previousHalfedge(h)])
      {
        --left;
        if (opposite[previousHalfedge(h)] == first[v])
        {
          break;
        }
      }
      hasSeveral[v] = left != 0 ? 1 : 0;
    });
  std::vector<int> severalFans;
  for (int v = 0; v < vertexCount; ++v)
  {
    if (hasSeveral[v] != 0)
    {
      severalFans.push_back(v);
    }
  }
  return severalFans;
}

} // namespace flattening
