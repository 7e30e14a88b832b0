// SPDX-License-Identifier: GPL-3.0-or-later
/// Surfaces with many defects, for tests that the code answers every one of them with a disk or an
/// error.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <cstdint>
#include <string>

namespace flattening::samples
{

struct RandomSurface
{
  TriangleMesh Mesh;
  std::string Recipe; ///< what it was made of, in words
};

/// A random shape (RandomShapes.h) with up to four defects (SurfaceDefects.h), reordered and scaled; one
/// in thirty cannot be repaired. The same seed gives the same surface on every platform.
RandomSurface randomSurface(std::uint64_t seed);

} // namespace flattening::samples
