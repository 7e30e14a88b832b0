// SPDX-License-Identifier: GPL-3.0-or-later
/// Surfaces as bad as they come, for tests that ask for an answer to every one of them.
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
