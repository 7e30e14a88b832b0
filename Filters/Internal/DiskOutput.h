// SPDX-License-Identifier: GPL-3.0-or-later
/// What Surface To Disk hands over: the disk as polydata, with the arrays of its input and the account
/// of what was changed.
#pragma once

#include "Core/Disk/SurfaceToDisk.h"

#include <vtkType.h>

#include <vector>

class vtkPolyData;

namespace flattening
{

/// Name of the point array (vtkIdType) with the input point that each point is; -1 if it is none.
inline constexpr const char* OriginalPointIdsName = "vtkOriginalPointIds";
/// Name of the cell array (vtkIdType) with the input cell that each cell is a part of; -1 if of none.
inline constexpr const char* OriginalCellIdsName = "vtkOriginalCellIds";

/// Fills @p output with the disk, all arrays of @p input carried over to it, and the arrays
/// vtkOriginalPointIds, vtkOriginalCellIds, Filled and Seam.
/// @param cellOfTriangle the cell of @p input that each triangle of the disk's origin is a part of.
void setDisk(vtkPolyData* output,
  vtkPolyData* input,
  const std::vector<vtkIdType>& cellOfTriangle,
  const DiskSurface& disk);

/// Adds the report to the field data of @p output, one array per figure.
void setReport(vtkPolyData* output, const SurfaceToDiskReport& report, vtkIdType droppedCells);

} // namespace flattening
