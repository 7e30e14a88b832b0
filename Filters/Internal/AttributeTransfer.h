// SPDX-License-Identifier: GPL-3.0-or-later
/// Transfer of the point and cell arrays of a surface to a mesh derived from it.
#pragma once

#include "Core/Mesh/DerivedMesh.h"

#include <vtkType.h>

#include <vector>

class vtkCellData;
class vtkPointData;

namespace flattening
{

/// Transfers point arrays. Arrays of floating point numbers are interpolated with the weights of the
/// origins; all others take the value of the original vertex with the largest weight, the first of equal
/// ones. A vertex without origins gets 0 or an empty string. Active attributes stay active; global ids
/// are left out.
void transferPointData(vtkPointData* from, const VertexOrigins& origins, vtkPointData* to);

/// Transfers cell arrays: each cell takes the values of its original cell, or 0 or an empty string if it
/// has none (-1).
void transferCellData(vtkCellData* from, const std::vector<vtkIdType>& origins, vtkCellData* to);

} // namespace flattening
