// SPDX-License-Identifier: GPL-3.0-or-later
/// A disk in which one vertex has many edges.
#pragma once

#include "Support/SampleSurfaces.h"

#include <cmath>

namespace flattening::samples
{

/// A flat cap of height 0.3 and radius 1: circles of points around vertex 0, which has an edge to each
/// of the @p spokes points of the first circle.
inline TriangleMesh hubDisk(int spokes, int circles)
{
  TriangleMesh mesh;
  mesh.Vertices.resize(1 + spokes * circles, 3);
  mesh.Vertices.row(0) << 0.0, 0.0, 0.3;
  mesh.Faces.resize(spokes * (2 * circles - 1), 3);
  const auto at = [spokes](int circle, int spoke) { return 1 + circle * spokes + spoke % spokes; };
  int f = 0;
  for (int i = 0; i < circles; ++i)
  {
    const double radius = (i + 1.0) / circles;
    for (int j = 0; j < spokes; ++j)
    {
      const double angle = 2.0 * Pi * j / spokes;
      mesh.Vertices.row(at(i, j)) << radius * std::cos(angle), radius * std::sin(angle),
        0.3 * (1.0 - radius * radius);
      if (i == 0)
      {
        mesh.Faces.row(f++) << 0, at(0, j), at(0, j + 1);
        continue;
      }
      mesh.Faces.row(f++) << at(i - 1, j), at(i, j), at(i, j + 1);
      mesh.Faces.row(f++) << at(i - 1, j), at(i, j + 1), at(i - 1, j + 1);
    }
  }
  return mesh;
}

} // namespace flattening::samples
