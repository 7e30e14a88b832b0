// SPDX-License-Identifier: GPL-3.0-or-later
/// Flags of vertices while a surface is cut open.
#pragma once

#include "Disk/EdgeCut.h"

#include <vector>

namespace flattening
{

/// Flags of vertices that are made of others, whose flags are given: 1 if all, or any, of these are
/// flagged.
std::vector<char> flagsOf(const VertexOrigins& origins, const std::vector<char>& flags, bool all);

/// The number of vertices that are flagged and on the seam of the cut. @p flags has one flag per vertex
/// of the cut surface, or is empty.
int countOnSeam(const std::vector<char>& flags, const CutSurface& cut);

} // namespace flattening
