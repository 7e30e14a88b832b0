// SPDX-License-Identifier: GPL-3.0-or-later
/// Small angles that a seam leaves in the faces that it divides.
#pragma once

#include "Base/Progress.h"
#include "Disk/SurfaceToDiskOptions.h"

namespace flattening
{

/// Opens angles below @p degrees in the disk, where that can be done without a change of its boundary
/// (withoutSmallAnglesInside): the banks of the seam still have the same points.
/// @throws Cancelled.
void openAnglesBesideSeam(DiskSurface& disk, double degrees, const ProgressCallback& progress = {});

} // namespace flattening
