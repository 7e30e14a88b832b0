// SPDX-License-Identifier: GPL-3.0-or-later
/// Points, lines and polygons that Planar Warp carries.
#pragma once

#include "Internal/WarpRules.h"

class vtkPolyData;

namespace flattening
{

/// Fills @p output with what is carried of @p input, its arrays, SurfacePoints and InMap.
/// @throws InvalidInput as requireSomeInside and segmentParts.
CarryCounts warpPolyData(vtkPolyData* input, const WarpRules& rules, vtkPolyData* output);

} // namespace flattening
