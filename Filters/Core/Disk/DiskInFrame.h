// SPDX-License-Identifier: GPL-3.0-or-later
/// The options and the result of surfaceToDisk in a frame of coordinates.
#pragma once

#include "Disk/SurfaceToDiskOptions.h"
#include "Mesh/CoordinateFrame.h"

namespace flattening
{

/// The options with their lengths and points, which are in input units, in the frame.
SurfaceToDiskOptions normalised(const SurfaceToDiskOptions& options, const CoordinateFrame& frame);

/// Turns the coordinates, lengths and areas of a disk that was made in the frame into input units.
void restoreUnits(DiskSurface& disk, const CoordinateFrame& frame);

} // namespace flattening
