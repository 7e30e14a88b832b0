// SPDX-License-Identifier: GPL-3.0-or-later
/// Layers of a surface, one behind the other as seen from one end of it.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The smallest number of edges from one end of each component to a corner of each face. The end is a
/// vertex that is farthest, in edges, from the component's first vertex.
std::vector<int> levelsOfFaces(const TriangleMesh& mesh);

/// Divides faces with these levels into @p layers layers of nearly equally many faces. Returns the level
/// with which each layer but the first begins, ascending.
std::vector<int> firstLevels(const std::vector<int>& levels, int layers);

} // namespace flattening
