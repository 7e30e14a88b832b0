// SPDX-License-Identifier: GPL-3.0-or-later
/// Surfaces of random shape, all consistently oriented, of a few hundred to a few thousand faces.
#pragma once

#include "Mesh/TriangleMesh.h"
#include "Support/RandomNumbers.h"

namespace flattening::samples
{

/// A sphere with bumps; closed, genus 0.
TriangleMesh bumpySphere(RandomNumbers& random);

/// @p rings tori in a row, each merged with the next: closed, genus @p rings.
TriangleMesh chainOfRings(RandomNumbers& random, int rings);

/// Isosurface of smoothed noise, as a scan of poor quality has it: many components, handles, and with @p
/// padded false boundaries where it leaves the volume. Without smoothing, nearly every cell is cut.
TriangleMesh noiseSurface(RandomNumbers& random, int smoothing, bool padded);

/// The squares, in two triangles each, between the voxels of a block with tunnels and missing voxels and
/// the outside. Non-manifold where voxels touch along an edge or in a corner only.
TriangleMesh piercedVoxels(RandomNumbers& random);

} // namespace flattening::samples
