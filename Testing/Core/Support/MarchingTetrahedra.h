// SPDX-License-Identifier: GPL-3.0-or-later
/// Isosurfaces of small volumes, for tests without VTK.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace flattening::samples
{

/// Values at the points of a grid of unit spacing, x fastest.
struct Volume
{
  std::array<int, 3> Size;
  std::vector<double> Values;

  explicit Volume(const std::array<int, 3>& size)
    : Size(size)
    , Values(static_cast<std::size_t>(size[0]) * size[1] * size[2])
  {
  }

  int index(int x, int y, int z) const { return x + this->Size[0] * (y + this->Size[1] * z); }
  double& at(int x, int y, int z) { return this->Values[this->index(x, y, z)]; }
  double at(int x, int y, int z) const { return this->Values[this->index(x, y, z)]; }
};

/// The surface around the values above 0, with outward normals: a manifold that is closed except where
/// it leaves the volume, with the slivers that contouring makes. Every cube is six tetrahedra around one
/// of its diagonals (Kuhn 1960), linear in each.
TriangleMesh marchingTetrahedra(const Volume& volume);

} // namespace flattening::samples
