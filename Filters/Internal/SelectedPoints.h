// SPDX-License-Identifier: GPL-3.0-or-later
/// The points or cells of a surface that a ParaView selection, an array or an implicit function selects.
#pragma once

#include "Core/Mesh/TriangleMesh.h"
#include "Internal/ChosenArray.h"

#include <vector>

class vtkImplicitFunction;
class vtkPolyData;
class vtkSelection;

namespace flattening
{

/// One flag per point of @p data: 1 for selected points and the corners of selected cells.
/// @throws InvalidInput if there is no selection, or it is a query, which VTK alone cannot evaluate.
std::vector<char> pointsInSelection(vtkPolyData* data, vtkSelection* selection);

/// One flag per point of @p data: 1 where the point array is not 0, or at the corners of cells where the
/// cell array is not 0.
/// @throws InvalidInput if a value is not finite.
std::vector<char> pointsWhereNotZero(vtkPolyData* data, const ChosenArray& array);

/// One flag per cell of @p data, which are triangles: 1 for selected cells, or for cells with two
/// selected corners.
/// @throws InvalidInput as pointsInSelection does.
std::vector<char> cellsInSelection(vtkPolyData* data, vtkSelection* selection);

/// One flag per position (n x 3): 1 where the function is <= 0, or >= 0 if @p outside.
/// @throws InvalidInput if there is no function, or if its value is NaN at a position.
std::vector<char> pointsInFunction(vtkImplicitFunction* function,
  const Points3& positions,
  bool outside);

} // namespace flattening
