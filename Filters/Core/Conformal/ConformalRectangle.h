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
  /// The boundary vertices that become the lower left, lower right, upper right and upper left corner:
  /// in the order of the boundary with the surface on its left. Or none: see rectangleCorners().
  std::vector<int> Corners;
  RicciFlowOptions Flow;
};

struct ConformalRectangleMap
{
  ConformalDiskMap Map;     ///< with positions in [0, Modulus] x [0, 1], the boundary on its sides
  double Modulus = 0.0;     ///< width / height: the surface has no conformal map to another rectangle
  std::vector<int> Corners; ///< four, as in ConformalRectangleOptions
};

/// Maps @p mesh conformally to a rectangle. Discrete Ricci flow as for the disk (RicciFlow.h), but with
/// angle sums of pi / 2 at the corners; no point goes to infinity. The shape of the rectangle comes out.
/// (Springborn, Schroeder, Pinkall 2008, section 5.)
/// @throws InvalidInput, TopologyError (see requireDisk), InvalidInput if the corners are not four
/// different boundary vertices in order or the boundary has fewer vertices, ConvergenceError, Cancelled.
ConformalRectangleMap conformalRectangleMap(const TriangleMesh& mesh,
  const ConformalRectangleOptions& options = {},
  const ProgressCallback& progress = {});

/// The four places where the boundary @p loop turns most sharply, seen over a fortieth of its length to
/// either side, if it turns by at least 45 degrees there; otherwise four points a quarter of its length
/// apart, the first being the one farthest from the surface's centroid. The first corner is the one
/// after which the longer pair of sides begins; among the two of that kind, the one farther from the
/// centroid.
std::vector<int> rectangleCorners(const TriangleMesh& mesh, const std::vector<int>& loop);

/// The corners of a tube that was cut open from end to end: where the two sides of the seam, the
/// vertices marked in @p onSeam (one flag per vertex), meet the tube's ends. The first corner begins the
/// side of the seam that starts at the longer end: the lower side of the rectangle, so that its modulus
/// is that of the tube, length over circumference. None if the marked vertices are not two stretches of
/// the boundary @p loop, of two vertices at least, with others between them.
std::vector<int> seamCorners(const TriangleMesh& mesh,
  const std::vector<int>& loop,
  const std::vector<char>& onSeam);

} // namespace flattening
