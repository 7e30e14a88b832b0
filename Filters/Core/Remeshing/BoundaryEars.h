// SPDX-License-Identifier: GPL-3.0-or-later
/// Faces with two boundary edges, which are called ears.
#pragma once

#include "Remeshing/MeshOnSurface.h"

namespace flattening
{

/// Gives the vertex between the two boundary edges of an ear another edge: in a map to a round domain
/// the angle there is nearly straight, so that the ear has hardly any area. The third edge of the ear is
/// flipped or, where that would make another ear or @p mayFlip forbids it, split at its middle, which
/// moves onto the old surface if @p mayMove allows it (MeshOnSurface::split). The boundary stays.
void openEars(MeshOnSurface& surface,
  const MeshOnSurface::Guard& mayFlip,
  const MeshOnSurface::Guard& mayMove);

} // namespace flattening
