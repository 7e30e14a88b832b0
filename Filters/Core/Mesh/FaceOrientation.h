// SPDX-License-Identifier: GPL-3.0-or-later
/// Which faces of a flat mesh are flipped, decided exactly.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// Orientation of every face (m): 1 counter-clockwise, 0 degenerate, -1 clockwise (flipped). Exact for
/// the given doubles, whatever their size (CGAL's filtered predicate). Positions must be finite.
std::vector<signed char> faceOrientations(const Points2& positions, const FaceMatrix& faces);

/// The same of row @p face of @p faces alone.
signed char faceOrientation(const Points2& positions, const FaceMatrix& faces, int face);

/// Number of faces with orientation 0 or -1: a face of no area is not mapped bijectively either.
int countFlippedFaces(const Points2& positions, const FaceMatrix& faces);

} // namespace flattening
