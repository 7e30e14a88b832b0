// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/MarchingTetrahedra.h"

#include "Support/SampleSurfaces.h"

#include <algorithm>
#include <map>
#include <utility>

namespace flattening::samples
{
namespace
{

using Tetrahedron = std::array<int, 4>; // grid points, positively oriented

// For each set of inside corners (bit k stands for corner k), an even permutation that puts them first,
// so that only one case is left for each number of inside corners.
constexpr std::array<std::array<int, 4>, 16> InsideFirst = { { { 0, 1, 2, 3 },
  { 0, 1, 2, 3 },
  { 1, 0, 3, 2 },
  { 0, 1, 2, 3 },
  { 2, 3, 0, 1 },
  { 0, 2, 3, 1 },
  { 1, 2, 0, 3 },
  { 0, 1, 2, 3 },
  { 3, 2, 1, 0 },
  { 0, 3, 1, 2 },
  { 1, 3, 2, 0 },
  { 0, 3, 1, 2 },
  { 2, 3, 0, 1 },
  { 0, 2, 3, 1 },
  { 1, 3, 2, 0 },
  { 0, 1, 2, 3 } } };

class Contour
{
public:
  explicit Contour(const Volume& volume)
    : Values(volume)
  {
  }

  void add(const Tetrahedron& tetrahedron)
  {
    int inside = 0;
    int count = 0;
    for (int k = 0; k < 4; ++k)
    {
      if (this->Values.Values[tetrahedron[k]] > 0.0)
      {
        inside |= 1 << k;
        ++count;
      }
    }
    const auto& order = InsideFirst[inside];
    const int a = tetrahedron[order[0]];
    const int b = tetrahedron[order[1]];
    const int c = tetrahedron[order[2]];
    const int d = tetrahedron[order[3]];
    if (count == 1)
    {
      this->Faces.push_back({ this->cut(a, b), this->cut(a, c), this->cut(a, d) });
    }
    else if (count == 2)
    {
      this->Faces.push_back({ this->cut(a, c), this->cut(a, d), this->cut(b, d) });
      this->Faces.push_back({ this->cut(a, c), this->cut(b, d), this->cut(b, c) });
    }
    else if (count == 3)
    {
      this->Faces.push_back({ this->cut(a, d), this->cut(b, d), this->cut(c, d) });
    }
  }

  TriangleMesh surface() const { return meshOf(this->Points, this->Faces); }

private:
  std::array<double, 3> position(int point) const
  {
    const int nx = this->Values.Size[0];
    const int ny = this->Values.Size[1];
    return { double(point % nx), double(point / nx % ny), double(point / nx / ny) };
  }

  // The point of the surface on an edge of the grid.
  int cut(int a, int b)
  {
    const auto edge = std::minmax(a, b);
    const auto [it, isNew] = this->Cuts.try_emplace(edge, static_cast<int>(this->Points.size()));
    if (isNew)
    {
      const double low = this->Values.Values[edge.first];
      const double share = low / (low - this->Values.Values[edge.second]);
      std::array<double, 3> point = this->position(edge.first);
      const std::array<double, 3> end = this->position(edge.second);
      for (int k = 0; k < 3; ++k)
      {
        point[k] += share * (end[k] - point[k]);
      }
      this->Points.push_back(point);
    }
    return it->second;
  }

  const Volume& Values;
  std::map<std::pair<int, int>, int> Cuts;
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<int, 3>> Faces;
};

} // namespace

TriangleMesh marchingTetrahedra(const Volume& volume)
{
  Contour contour(volume);
  std::array<int, 3> axes = { 0, 1, 2 };
  // A tetrahedron takes one step along each axis, from one corner of the cube to the opposite one.
  do
  {
    const bool even = (axes[1] - axes[0] + 3) % 3 == 1;
    for (int z = 0; z + 1 < volume.Size[2]; ++z)
    {
      for (int y = 0; y + 1 < volume.Size[1]; ++y)
      {
        for (int x = 0; x + 1 < volume.Size[0]; ++x)
        {
          std::array<int, 3> corner = { x, y, z };
          Tetrahedron tetrahedron;
          tetrahedron[0] = volume.index(x, y, z);
          for (int k = 0; k < 3; ++k)
          {
            ++corner[axes[k]];
            tetrahedron[k + 1] = volume.index(corner[0], corner[1], corner[2]);
          }
          if (!even)
          {
            std::swap(tetrahedron[1], tetrahedron[2]);
          }
          contour.add(tetrahedron);
        }
      }
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return contour.surface();
}

} // namespace flattening::samples
