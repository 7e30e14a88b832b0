// SPDX-License-Identifier: GPL-3.0-or-later
/// A surface after a cut along a closed loop and the closing of both sides by caps.
#pragma once

#include "Handles/FaceIntersections.h"
#include "Handles/LoopCapping.h"

#include <vector>

namespace flattening
{

struct CappedCut
{
  std::vector<int> Vertices; ///< of the loop
  LoopCap Cap;
  // New vertices are numbered in this order: copies of the loop's vertices, which belong to the side on
  // its left, inner vertices of the cap on the right, inner vertices of the cap on the left.
  int FirstCopy = 0;
  int FirstRight = 0;
  int FirstLeft = 0;
  /// First the faces that meet the loop, in the order of Replaced, then those of the caps.
  FaceReplacement Faces;
};

/// Plans a cut along @p loop and its closing by two copies of @p cap; the surface stays as it is. On
/// each side the loop's vertices move by the share @p step (0 to 1) of the way to the centre of area of
/// the faces around them, and the caps move with them, so that the two sides come apart.
CappedCut capBothSides(const HalfedgeSurface& surface,
  const std::vector<int>& loop,
  const LoopCap& cap,
  double step);

} // namespace flattening
