// SPDX-License-Identifier: GPL-3.0-or-later
/// The output of Surface To Disk: the disk as polydata with the arrays of the input, and the report of
/// the changes in its field data.
#pragma once

#include "Core/Disk/SurfaceToDisk.h"

#include <Eigen/Core>

#include <vtkType.h>

#include <vector>

class vtkPolyData;

namespace flattening
{

/// Fills @p output with the disk, the arrays of @p input transferred to it, and the arrays
/// vtkOriginalPointIds, vtkOriginalCellIds, Filled and Seam.
/// @param cellOfTriangle the cell of @p input that each triangle of the triangulated input is part of.
void setDisk(vtkPolyData* output,
  vtkPolyData* input,
  const std::vector<vtkIdType>& cellOfTriangle,
  const DiskSurface& disk);

/// The flags of the points on seams that an earlier Surface To Disk cut, from the array Seam; empty if
/// there is none.
std::vector<char> banksOf(vtkPolyData* input);

/// Adds the point array ScaledCurvature, and makes it the active scalars, which viewers show first, unless
/// others vary over the disk. The scalars of an isosurface are its isovalue everywhere.
void setScaledCurvature(vtkPolyData* disk, const Eigen::VectorXd& curvature);

/// Adds the report to the field data of @p output, one array per value.
/// @param droppedCells number of vertices and lines of the input.
void setReport(vtkPolyData* output, const SurfaceToDiskReport& report, vtkIdType droppedCells);

} // namespace flattening
