// SPDX-License-Identifier: GPL-3.0-or-later
#include "Repair/NeedlesAndCaps.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
namespace
{

using Triangle = std::array<int, 3>;

// Classes of joined vertices; the smallest of each represents it.
class JoinedVertices
{
public:
  explicit JoinedVertices(Eigen::Index count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  int representative(int v)
  {
    while (this->Parent[v] != v)
    {
      v = this->Parent[v] = this->Parent[this->Parent[v]];
    }
    return v;
  }

  // Returns whether they were two.
  bool join(int a, int b)
  {
    a = this->representative(a);
    b = this->representative(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

private:
  std::vector<int> Parent;
};

// Joins the ends of the face's shortest edge if that is too short.
bool joinIfNeedle(const Points3& vertices, const Triangle& face, JoinedVertices& joined)
{
  std::array<double, 3> length;
  for (int k = 0; k < 3; ++k)
  {
    length[k] = (vertices.row(face[k]) - vertices.row(face[(k + 1) % 3])).norm();
  }
  const auto [shortest, longest] = std::minmax_element(length.begin(), length.end());
  if (*shortest > SmallestEdgeShare * *longest)
  {
    return false;
  }
  const auto k = shortest - length.begin();
  return joined.join(face[k], face[(k + 1) % 3]);
}

} // namespace

CollapsedNeedles collapseNeedles(const Points3& vertices,
  std::vector<Triangle>& faces,
  std::vector<int>& origins)
{
  CollapsedNeedles collapsed;
  JoinedVertices joined(vertices.rows());
  for (bool found = true; found;)
  {
    found = false;
    for (const Triangle& face : faces)
    {
      if (joinIfNeedle(vertices, face, joined))
      {
        ++collapsed.Vertices;
        found = true;
      }
    }
    std::size_t kept = 0;
    for (std::size_t f = 0; found && f < faces.size(); ++f)
    {
      for (int& v : faces[f])
      {
        v = joined.representative(v);
      }
      const auto [a, b, c] = faces[f];
      if (a != b && b != c && c != a)
      {
        faces[kept] = faces[f];
        origins[kept++] = origins[f];
      }
    }
    if (found)
    {
      collapsed.Faces += static_cast<int>(faces.size() - kept);
      faces.resize(kept);
      origins.resize(kept);
    }
  }
  return collapsed;
}

} // namespace flattening
