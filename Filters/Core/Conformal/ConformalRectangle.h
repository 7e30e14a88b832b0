// SPDX-License-Identifier: GPL-3.0-or-later
/// The conformal map of a surface of disk topology to a rectangle.
#pragma once

#include "Base/Progress.h"
#include "Conformal/ConformalDiskMap.h"
#include "Conformal/RicciFlow.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

struct ConformalRectangleOptions
{
  /// The boundary vertices that become the lower left, lower right, upper right and upper left corner,
  /// in the order of the boundary with the surface on its left; or none for rectangleCorners().
  std::vector<int> Corners;
  RicciFlowOptions Flow;
};

struct ConformalRectangleMap
{
  ConformalDiskMap Map;     ///< with positions in [0, Modulus] x [0, 1], the boundary on its sides
  double Modulus = 0.0;     ///< width / height: the surface has no conformal map to other rectangles
  std::vector<int> Corners; ///< the four corners, as in ConformalRectangleOptions
};

/// Maps @p mesh conformally to a rectangle, by discrete Ricci flow as for the disk (RicciFlow.h), but
/// with angle sums of pi / 2 at the corners and no point at infinity. The rectangle's shape is a result.
/// (Springborn, Schroeder, Pinkall 2008, section 5.)
/// @throws InvalidInput, TopologyError (see requireDisk); InvalidInput if the corners are not four
/// different boundary vertices in order or the boundary has fewer than four vertices; ConvergenceError;
/// Cancelled.
ConformalRectangleMap conformalRectangleMap(const TriangleMesh& mesh,
  const ConformalRectangleOptions& options = {},
  const ProgressCallback& progress = {});

/// The four vertices where the boundary @p loop turns most sharply, seen over a fortieth of its length
/// to either side, if it turns by at least 45 degrees at each of them. Otherwise, four vertices a
/// quarter of its length apart, beginning with the one farthest from the surface's centroid. The longer
/// pair of sides begins after the first corner; of the two corners of that kind, the first is the one
/// farther from the centroid.
std::vector<int> rectangleCorners(const TriangleMesh& mesh, const std::vector<int>& loop);

/// The corners of a tube that was cut open from end to end: the vertices where the two sides of the
/// seam, marked in @p onSeam (one flag per vertex), meet the tube's ends. The first corner begins the
/// side of the seam that starts at the longer end. That side becomes the lower side of the rectangle, so
/// that the modulus is the length of the tube over its circumference. Empty if the marked vertices are
/// not two stretches of the boundary @p loop, each of at least two vertices, with others between them.
std::vector<int> seamCorners(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const std::vector<char>& onSeam);

} // namespace flattening
