// SPDX-License-Identifier: GPL-3.0-or-later
/// Whether a mesh is a disk, counted without the code under test.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <string>

namespace flattening::samples
{

/// What keeps @p mesh from being one clean oriented disk with finite coordinates and positive areas;
/// empty if nothing does.
std::string diskDefect(const TriangleMesh& mesh);

} // namespace flattening::samples
