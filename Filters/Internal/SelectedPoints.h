// SPDX-License-Identifier: GPL-3.0-or-later
/// Which points of a surface a ParaView selection, an array or an implicit function choose.
#pragma once

#include "Core/Mesh/TriangleMesh.h"
#include "Internal/ChosenArray.h"

#include <vector>

class vtkImplicitFunction;
class vtkPolyData;
class vtkSelection;

namespace flattening
{

/// One flag per point of @p data: the points that @p selection holds, and the corners of its cells.
/// @throws InvalidInput if there is no selection, or it is a query, which VTK alone does not evaluate.
std::vector<char> pointsInSelection(vtkPolyData* data, vtkSelection* selection);

/// One flag per point of @p data: those where the array is not 0, or that are corners of a cell where it
/// is not.
/// @throws InvalidInput if a value is no number.
std::vector<char> pointsWhereNotZero(vtkPolyData* data, const ChosenArray& array);

/// One flag per cell of @p data, triangles: those that @p selection holds, or of whose corners it holds
/// two.
/// @throws InvalidInput as pointsInSelection.
std::vector<char> cellsInSelection(vtkPolyData* data, vtkSelection* selection);

/// One flag per position: where the function is not positive, or not negative if @p outside.
/// @throws InvalidInput if there is no function or it gives no number somewhere.
std::vector<char> pointsInFunction(vtkImplicitFunction* function,
  const Points3& positions,
  bool outside);

} // namespace flattening
