// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/FaceSides.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

namespace flattening
{

std::vector<FaceSide> sortedSides(const FaceMatrix& faces)
{
  std::vector<FaceSide> sides(faces.size());
  for (int h = 0; h < static_cast<int>(sides.size()); ++h)
  {
    const int from = faces(h / 3, h % 3);
    const int to = faces(h / 3, (h + 1) % 3);
    const auto edge = (static_cast<std::uint64_t>(std::min(from, to)) << 32) |
                      static_cast<std::uint64_t>(std::max(from, to));
    sides[h] = { edge, from, to, h };
  }
  tbb::parallel_sort(sides.begin(),
    sides.end(),
    [](const FaceSide& a, const FaceSide& b)
    { return std::tie(a.Edge, a.Halfedge) < std::tie(b.Edge, b.Halfedge); });
  return sides;
}

std::vector<int> oppositeHalfedges(const FaceMatrix& faces)
{
  std::vector<int> opposite(faces.size(), -1);
  const std::vector<FaceSide> sides = sortedSides(faces);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    while (end < sides.size() && sides[end].Edge == sides[begin].Edge)
    {
      ++end;
    }
    if (end - begin == 2 && sides[begin].From == sides[begin + 1].To &&
        sides[begin].From != sides[begin].To)
    {
      opposite[sides[begin].Halfedge] = sides[begin + 1].Halfedge;
      opposite[sides[begin + 1].Halfedge] = sides[begin].Halfedge;
    }
  }
  return opposite;
}

} // namespace flattening
