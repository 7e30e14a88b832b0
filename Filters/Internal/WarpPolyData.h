// SPDX-License-Identifier: GPL-3.0-or-later
/// Planar Warp of points, lines and polygons.
#pragma once

#include "Internal/WarpRules.h"

class vtkPolyData;

namespace flattening
{

/// Fills @p output with the warped points and cells of @p input, its arrays, SurfacePoints and InMap.
/// @throws InvalidInput as requireSomeInside and segmentParts do.
WarpCounts warpPolyData(vtkPolyData* input, const WarpRules& rules, vtkPolyData* output);

} // namespace flattening
