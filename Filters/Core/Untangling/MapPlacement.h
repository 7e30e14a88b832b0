// SPDX-License-Identifier: GPL-3.0-or-later
/// A flat map in the coordinates in which it is put out.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace flattening
{

/// The map x -> Scale x + Centre.
struct Placement
{
  double Scale = 1.0; ///< > 0
  Eigen::RowVector2d Centre = Eigen::RowVector2d::Zero();
};

struct PlacedMap
{
  Points2 Positions;    ///< n x 2
  int FlippedFaces = 0; ///< faces not positively oriented (exact), in these positions
};

/// Places a flat map. Rounding may flip the thinnest of its faces; if no face is flipped before, these
/// are untangled in their new places (untangleMap, by their shapes in the map). Vertices that are
/// @p fixed stay.
PlacedMap placeMap(const TriangleMesh& surface,
  const std::vector<int>& fixed,
  const Points2& positions,
  const Placement& placement);

} // namespace flattening
