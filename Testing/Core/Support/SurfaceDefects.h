// SPDX-License-Identifier: GPL-3.0-or-later
/// What goes wrong with surfaces from scanners, from editing programs and on the way between them, at
/// random places and to a random extent. Every surface has at least one face before and after.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Support/RandomNumbers.h"

#include <string>
#include <vector>

namespace flattening::samples
{

struct SurfaceDefect
{
  const char* Name;
  void (*Apply)(TriangleMesh&, RandomNumbers&);
};

/// Holes, fragments, T-junctions, slivers and collapsed faces, flipped and duplicated faces, fins,
/// shared edges and points, isolated points, points of each face's own, noise. In this order they can
/// all be put on one surface.
const std::vector<SurfaceDefect>& surfaceDefects();

/// Puts faces and points in another order; scales the surface by 1e-9 to 1e9 and moves it by up to a
/// thousand times its size.
void shuffleAndScale(TriangleMesh& mesh, RandomNumbers& random);

/// What no repair can help: not a number or infinite as a coordinate in use, an index out of range, a
/// Moebius strip larger than the rest, or all faces degenerate. Returns which.
std::string damage(TriangleMesh& mesh, RandomNumbers& random);

} // namespace flattening::samples
