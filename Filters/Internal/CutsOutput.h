// SPDX-License-Identifier: GPL-3.0-or-later
/// The second output of Surface To Disk: the boundary of the disk as lines on the surface.
#pragma once

#include "Core/Disk/SeamSegments.h"

class vtkPolyData;

namespace flattening
{

/// Name of the point and cell array (int): the number of a piece of the seams, from 1; 0 off the seams.
inline constexpr const char* SeamIdName = "SeamId";

/// Adds the point arrays SeamId and SeamDistance to the disk.
void addSeamArrays(vtkPolyData* disk, const SeamSegments& seams);

/// Fills @p cuts with a polyline for each piece of the seams and of the border, with the point arrays of
/// the disk and the cell arrays SeamId and Length. A point is there once, so that lines meet.
void setCuts(vtkPolyData* cuts, vtkPolyData* disk, const SeamSegments& seams);

} // namespace flattening
