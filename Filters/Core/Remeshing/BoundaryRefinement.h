// SPDX-License-Identifier: GPL-3.0-or-later
/// Enough vertices on a boundary that becomes the boundary of a flat disk.
#pragma once

#include "Mesh/DerivedMesh.h"

namespace flattening
{

/// Gives the longest boundary loop (input units) of an oriented manifold at least @p minimumVertices
/// vertices by longest-edge bisection of the faces along it; the surface stays as it is. Nothing changes
/// if it has as many or there is no boundary.
DerivedMesh refineBoundary(const TriangleMesh& mesh, int minimumVertices);

} // namespace flattening
