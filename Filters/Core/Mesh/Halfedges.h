// SPDX-License-Identifier: GPL-3.0-or-later
/// The numbering of half-edges: face f has the half-edges 3 f, 3 f + 1 and 3 f + 2, in its direction.
#pragma once

namespace flattening
{

/// The half-edges that one task of a parallel loop takes: enough to outweigh the cost of a task. Results
/// do not depend on it.
constexpr int HalfedgesPerTask = 4096;

/// The half-edge after @p h around its face.
constexpr int nextHalfedge(int h)
{
  return h % 3 == 2 ? h - 2 : h + 1;
}
/// The half-edge before @p h around its face.
constexpr int previousHalfedge(int h)
{
  return h % 3 == 0 ? h + 2 : h - 1;
}

} // namespace flattening
