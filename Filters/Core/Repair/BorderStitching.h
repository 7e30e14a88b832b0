// SPDX-License-Identifier: GPL-3.0-or-later
/// Joins borders that lie on each other.
#pragma once

#include "Mesh/DerivedMesh.h"

namespace flattening
{

/// Sews border edges together that coincide point for point and run against each other, where that gives
/// a manifold: closes the slits that cutting at non-manifold edges leaves (CGAL stitch_borders). Faces
/// stay, in their order.
DerivedMesh stitchCoincidentBorders(const TriangleMesh& mesh);

} // namespace flattening
