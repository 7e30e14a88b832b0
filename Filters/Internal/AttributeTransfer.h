// SPDX-License-Identifier: GPL-3.0-or-later
/// Carries the attributes of a surface over to a mesh derived from it.
#pragma once

#include "Core/Mesh/DerivedMesh.h"

#include <vtkType.h>

#include <vector>

class vtkCellData;
class vtkPointData;

namespace flattening
{

/// Arrays of floating point numbers are interpolated with the weights; all others take the value of the
/// original vertex of the largest weight, the first of equals; 0 (an empty string) without weights.
/// Active attributes stay active; global ids are left out.
void transferPointData(vtkPointData* from, const VertexOrigins& origins, vtkPointData* to);

/// Every array takes the values of the original cells, 0 (an empty string) where there is none (-1).
void transferCellData(vtkCellData* from, const std::vector<vtkIdType>& origins, vtkCellData* to);

} // namespace flattening
