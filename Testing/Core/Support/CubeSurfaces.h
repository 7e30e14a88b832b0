// SPDX-License-Identifier: GPL-3.0-or-later
/// Boundaries of unions of cubes, of known genus.
#pragma once

#include "Support/SampleSurfaces.h"

#include <array>
#include <map>
#include <set>
#include <vector>

namespace flattening::samples
{

using Cell = std::array<int, 3>;

/// Boundary of a union of unit cubes, each side of 2 k x k triangles. No two cubes may meet in an edge
/// or a corner alone.
inline TriangleMesh boundaryOf(const std::set<Cell>& cubes, int k = 1)
{
  std::map<Cell, int> index;
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> faces;
  const auto vertex = [&](const Cell& at)
  {
    const auto [place, isNew] = index.try_emplace(at, static_cast<int>(vertices.size()));
    if (isNew)
    {
      vertices.push_back({ double(at[0]) / k, double(at[1]) / k, double(at[2]) / k });
    }
    return place->second;
  };
  for (const Cell& cube : cubes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const int side : { 0, 1 })
      {
        Cell neighbour = cube;
        neighbour[axis] += side ? 1 : -1;
        if (cubes.count(neighbour))
        {
          continue;
        }
        const int u = (axis + (side ? 1 : 2)) % 3;
        const int v = (axis + (side ? 2 : 1)) % 3;
        for (int i = 0; i < k; ++i)
        {
          for (int j = 0; j < k; ++j)
          {
            const auto corner = [&](int a, int b)
            {
              Cell at{ k * cube[0], k * cube[1], k * cube[2] };
              at[axis] += side * k;
              at[u] += i + a;
              at[v] += j + b;
              return vertex(at);
            };
            const int p = corner(0, 0);
            const int q = corner(1, 1);
            faces.push_back({ p, corner(1, 0), q });
            faces.push_back({ p, q, corner(0, 1) });
          }
        }
      }
    }
  }
  return meshOf(vertices, faces);
}

/// A slab of (2 n + 1) x 3 cubes, two high, with n square tunnels through it.
inline TriangleMesh slabWithTunnels(int n, int k = 1)
{
  std::set<Cell> cubes;
  for (int x = 0; x <= 2 * n; ++x)
  {
    for (int y = 0; y < 3; ++y)
    {
      for (int z = 0; z < 2; ++z)
      {
        if (x % 2 == 0 || y != 1)
        {
          cubes.insert({ x, y, z });
        }
      }
    }
  }
  return boundaryOf(cubes, k);
}

/// A block with n arches of cubes on it.
inline TriangleMesh blockWithHandles(int n, int k = 1)
{
  std::set<Cell> cubes;
  for (int x = 0; x < 2 * n; ++x)
  {
    for (int y = 0; y < 5; ++y)
    {
      for (int z = 0; z < 3; ++z)
      {
        cubes.insert({ x, y, z });
      }
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (const int z : { 3, 4, 5 })
    {
      cubes.insert({ 2 * i, 0, z });
      cubes.insert({ 2 * i, 4, z });
    }
    for (const int y : { 1, 2, 3 })
    {
      cubes.insert({ 2 * i, y, 5 });
    }
  }
  return boundaryOf(cubes, k);
}

} // namespace flattening::samples
