// SPDX-License-Identifier: GPL-3.0-or-later
/// Local refinement that keeps the surface as it is and the mesh conforming.
#pragma once

#include "Mesh/EditableSurface.h"

#include <vector>

namespace flattening
{

/// Bisects the listed faces and what becomes of them until no edge of theirs is longer than
/// @p longestEdge (input units). Faces are split at the middle of their longest edge together with the
/// neighbour there, after whatever bisections of neighbours that takes, so that no angle falls below
/// half of the smallest one of the input (Rivara 1984; longest-edge propagation path).
void bisectLongEdges(EditableSurface& surface,
  const std::vector<EditableSurface::Face>& faces,
  double longestEdge);

} // namespace flattening
