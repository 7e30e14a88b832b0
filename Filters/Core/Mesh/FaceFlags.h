// SPDX-License-Identifier: GPL-3.0-or-later
/// Parts of a surface that are given by one flag per face.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The numbers of the flags that are set or, if @p value is false, of those that are not.
std::vector<int> flagged(const std::vector<char>& flags, bool value = true);

/// Sets the flags of all faces around each vertex at which parts of the flagged faces (if @p value is
/// false, of the others) hang together by the vertex alone, until there is no such vertex.
void flagAroundPinches(const TriangleMesh& mesh, std::vector<char>& flags, bool value);

} // namespace flattening
