// SPDX-License-Identifier: GPL-3.0-or-later
/// Flipped faces that the move of a single vertex turns over.
#pragma once

#include "Untangling/UntanglingMesh.h"

namespace flattening
{

/// Turns face @p f of @p mesh, which is flipped, over by the least move, relative to the edges there, of
/// one of its corners that makes all faces around that corner positive: to a place from which each of
/// them has a tenth of its target's altitude, or what it has if that is less.
/// @returns the vertex moved, or -1 if no such move was found and all is as it was.
int untangleByOneVertex(UntanglingMesh& mesh, int f);

} // namespace flattening
