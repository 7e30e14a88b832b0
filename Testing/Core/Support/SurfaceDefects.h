// SPDX-License-Identifier: GPL-3.0-or-later
/// Defects that surfaces from scanners and editing programs have, at random places and to a random
/// extent. Every surface has at least one face before and after.
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
/// shared edges and points, isolated points, faces that share no points, noise. One surface can get all
/// of them in this order.
const std::vector<SurfaceDefect>& surfaceDefects();

/// Puts faces and points in another order; scales the surface by 1e-9 to 1e9 and moves it by up to a
/// thousand times its size.
void shuffleAndScale(TriangleMesh& mesh, RandomNumbers& random);

/// Damages the surface so that it cannot be repaired: a coordinate in use becomes infinite or not a
/// number, an index is out of range, a Moebius strip is larger than the rest, or all faces become
/// degenerate. Returns the kind of damage.
std::string damage(TriangleMesh& mesh, RandomNumbers& random);

} // namespace flattening::samples
