// SPDX-License-Identifier: GPL-3.0-or-later
/// A part of a surface, in space or flattened, as polydata with the arrays of the surface.
#pragma once

#include "Core/Mesh/DerivedMesh.h"

class vtkPolyData;

namespace flattening
{

/// Fills @p output with @p part, all arrays of @p original, the point array vtkOriginalPointIds (-1 for
/// new points) and the cell array vtkOriginalCellIds (-1 for new cells).
/// @param cells the cell of @p original that each face of the original mesh is part of; empty: the cell
/// of the same number.
void setRegion(vtkPolyData* output,
  vtkPolyData* original,
  const DerivedMesh& part,
  const std::vector<vtkIdType>& cells = {});

/// Does the same with the points at @p positions (n x 2, z = 0), and adds the point arrays SurfacePoints
/// and TCoords. An array TCoords of @p original is renamed SurfaceTCoords; if @p original is a flat
/// map, which has SurfacePoints, TCoords is left out and SurfaceTCoords stays.
void setFlatRegion(vtkPolyData* output,
  vtkPolyData* original,
  const DerivedMesh& part,
  const Points2& positions);

} // namespace flattening
