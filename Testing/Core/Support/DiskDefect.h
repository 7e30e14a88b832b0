// SPDX-License-Identifier: GPL-3.0-or-later
/// A check that a mesh is a disk, independent of the code under test.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <string>

namespace flattening::samples
{

/// The reason why @p mesh is not one oriented manifold disk with finite coordinates and positive areas;
/// empty if it is one.
std::string diskDefect(const TriangleMesh& mesh);

} // namespace flattening::samples
