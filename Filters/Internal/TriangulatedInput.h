// SPDX-License-Identifier: GPL-3.0-or-later
/// The triangles of a surface that may have polygons and strips, and the cells that they are parts of.
#pragma once

#include "Internal/ChosenArray.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkPolyData;

namespace flattening
{

/// The triangles of all polygons and strips, with the points of @p input and the id of the input cell of
/// each in vtkOriginalCellIds.
/// @throws InvalidInput if a cell names a point that does not exist or is not finite.
vtkSmartPointer<vtkPolyData> triangulate(vtkPolyData* input);

/// The input cell of each triangle.
std::vector<vtkIdType> cellsOf(vtkPolyData* triangles);

/// One flag per triangle: 1 for the parts of cells with the label, or with two corners or more that have
/// it.
/// @throws InvalidInput if no array of labels was chosen.
std::vector<char> labelledTriangles(vtkPolyData* triangles, const ChosenArray& labels, int label);

} // namespace flattening
