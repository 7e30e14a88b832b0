// SPDX-License-Identifier: GPL-3.0-or-later
/// Untangling of a flat map: makes its flipped faces positively oriented.
#pragma once

#include "Base/Progress.h"
#include "Untangling/TargetTriangles.h"

#include <vector>

namespace flattening
{

struct UntanglingOptions
{
  /// The weight of areas in maps that keep them. A choice: areas count as much as shapes.
  static constexpr double EqualAreaWeight = 1.0;
  /// Weight of a face's area against its shape (see FoldoverEnergy), dimensionless, >= 0.
  double AreaWeight = 0.1;
  /// Greatest number of vertices that are moved together; flipped faces that need more stay flipped.
  int LargestPatch = 2000;
  /// Bound on the work for patches that stay flipped, per vertex of the map, >= 0. The work for a
  /// patch is the number of Newton steps times the number of free vertices. With a bound of 1, vain
  /// attempts do not take much longer than a conformal map.
  double WorkPerVertex = 1.0;
  /// Whether to end at the first face that stays flipped, as a map is of no use then. Off: the other
  /// faces are untangled nevertheless.
  bool AllOrNone = false;
};

struct UntanglingReport
{
  int RepairedFaces = 0;     ///< faces that were flipped or of no area and are positively oriented now
  int FlippedFaces = 0;      ///< faces that are still flipped or of no area
  int MovedVertices = 0;     ///< number of vertices whose positions have changed
  double GreatestMove = 0.0; ///< longest move over the mean side of the faces around its vertex
};

/// Moves as few vertices of the flat map @p positions (n x 2) of @p faces by as little as possible until
/// all faces are positively oriented, by more than the rounding of their corners. Vertices that are @p
/// fixed (n flags, not 0) stay.
///
/// First, single vertices go to the nearest point in the kernel of their star (untangleByOneVertex).
/// Then, patches around the flipped faces that are left are freed, their rims fixed, and grow until the
/// minimum of their energy (untanglePatch) has no flipped face. The minimum is sought from the positions
/// in the map and, if that fails, from Tutte's map. A patch that cannot be untangled, or only with more
/// work than the options allow, stays as it was. If no face is flipped in the end and the boundary does
/// not intersect itself, the map is one-to-one (docs/mathematics.md, "Untangling").
/// @throws Cancelled.
UntanglingReport untangleMap(const FaceMatrix& faces,
  const std::vector<char>& fixed,
  const TargetTriangles& targets,
  Points2& positions,
  const UntanglingOptions& options = {},
  const ProgressCallback& progress = {});

/// Untangles a conformal map of @p surface, in which every face should keep its shape
/// (similarTriangles). @p fixed lists the vertices that stay.
/// @throws Cancelled.
UntanglingReport untangleMap(const TriangleMesh& surface,
  const std::vector<int>& fixed,
  Points2& positions,
  const ProgressCallback& progress = {});

} // namespace flattening
