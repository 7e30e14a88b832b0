// SPDX-License-Identifier: GPL-3.0-or-later
/// Which faces of a flat mesh are flipped, decided exactly.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The orientation of every face (m): 1 counter-clockwise, 0 degenerate, -1 clockwise (flipped). It is
/// exact for the given doubles, whatever their size (CGAL's filtered predicate). Positions must be
/// finite.
std::vector<signed char> faceOrientations(const Points2& positions, const FaceMatrix& faces);

/// The orientation of the face in row @p face of @p faces.
signed char faceOrientation(const Points2& positions, const FaceMatrix& faces, int face);

/// Number of faces with orientation 0 or -1, because a face without area is not mapped bijectively
/// either.
int countFlippedFaces(const Points2& positions, const FaceMatrix& faces);

} // namespace flattening
