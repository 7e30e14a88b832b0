// SPDX-License-Identifier: GPL-3.0-or-later
/// Lengths in a mesh: between points, of sides of faces, and of ways along edges.
#pragma once

#include "Triangles.h"

#include <vector>

namespace fuzz
{

long double distanceBetween(const Point& a, const Point& b);

/// The mean length of the sides of the faces. A side that two faces share counts twice.
long double meanSide(const Triangles& mesh);

/// For each point of the mesh, the length of the shortest way along edges from one of the sources;
/// infinite if there is none.
std::vector<long double> distancesFrom(const Triangles& mesh, const std::vector<vtkIdType>& sources);

} // namespace fuzz
