// SPDX-License-Identifier: GPL-3.0-or-later
/// A part of a surface as polydata, in space or flattened, with the arrays of the surface.
#pragma once

#include "Core/Mesh/DerivedMesh.h"

class vtkPolyData;

namespace flattening
{

/// Fills @p output with @p part: all arrays of @p original, the point array vtkOriginalPointIds (-1 for
/// new points), the cell array vtkOriginalCellIds.
void setRegion(vtkPolyData* output, vtkPolyData* original, const DerivedMesh& part);

/// Fills @p output with @p part at @p positions (n x 2, z = 0): all arrays of @p original, the point
/// arrays SurfacePoints, TCoords and vtkOriginalPointIds (-1 for new points), the cell array
/// vtkOriginalCellIds. An array TCoords of @p original is called SurfaceTCoords.
void setFlatRegion(vtkPolyData* output,
  vtkPolyData* original,
  const DerivedMesh& part,
  const Points2& positions);

} // namespace flattening
