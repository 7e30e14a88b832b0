// SPDX-License-Identifier: GPL-3.0-or-later
/// Turns the flipped faces of a flat map over.
#pragma once

#include "Base/Progress.h"
#include "Untangling/TargetTriangles.h"

#include <vector>

namespace flattening
{

struct UntanglingOptions
{
  /// What a face's area counts against its shape (FoldoverEnergy), dimensionless, >= 0.
  double AreaWeight = 0.1;
  /// Most vertices that are moved together; flipped faces that would take more are left.
  int LargestPatch = 2000;
  /// Newton steps times vertices that may be in vain, per vertex of the map: what cannot be repaired
  /// should not take much longer than the map did.
  double WorkPerVertex = 1.0;
};

struct UntanglingReport
{
  int RepairedFaces = 0; ///< flipped or of no area before, positively oriented now
  int FlippedFaces = 0;  ///< still flipped or of no area
  int MovedVertices = 0;
  double GreatestMove = 0.0; ///< of a vertex, in mean lengths of the sides of its faces after the move
};

/// Moves as few vertices of the flat map @p positions (n x 2) of @p faces as little as it can until all
/// faces are positively oriented, by more than the rounding of their corners; those that are @p fixed
/// (n, not 0) stay. First, single vertices go to the nearest place in the kernel of their star
/// (untangleByOneVertex). Then, patches are freed around the flipped faces that are left, and grow until
/// their energy's minimum (untanglePatch) has no flipped face; their rims stay. Where that fails, or
/// would take much longer than a conformal map does, the map is left as it was. If no face is flipped
/// and the boundary does not intersect itself, the map is one-to-one.
/// @throws Cancelled.
UntanglingReport untangleMap(const FaceMatrix& faces,
  const std::vector<char>& fixed,
  const TargetTriangles& targets,
  Points2& positions,
  const UntanglingOptions& options = {},
  const ProgressCallback& progress = {});

/// The same for a conformal map of @p surface, whose vertices @p fixed, by their numbers, stay: every
/// face should keep its shape (similarTriangles).
/// @throws Cancelled.
UntanglingReport untangleMap(const TriangleMesh& surface,
  const std::vector<int>& fixed,
  Points2& positions,
  const ProgressCallback& progress = {});

} // namespace flattening
