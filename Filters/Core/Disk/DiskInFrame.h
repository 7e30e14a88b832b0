// SPDX-License-Identifier: GPL-3.0-or-later
/// The options and the result of surfaceToDisk in a frame of coordinates.
#pragma once

#include "Disk/SurfaceToDiskOptions.h"
#include "Mesh/CoordinateFrame.h"

#include <Eigen/Core>

#include <sstream>

namespace flattening
{

/// The options with their lengths and points, which are in input units, in the frame.
SurfaceToDiskOptions normalised(const SurfaceToDiskOptions& options, const CoordinateFrame& frame);

/// Turns the coordinates, lengths and areas of a disk that was made in the frame into input units.
void restoreUnits(DiskSurface& disk, const CoordinateFrame& frame);

/// Throws the error again with the units of the frame, in which its lengths and places are.
template <typename Error>
[[noreturn]] void throwInUnits(const Error& error, const CoordinateFrame& frame)
{
  std::ostringstream message;
  message << error.what() << " (";
  if (frame.changesSize())
  {
    message << "lengths here are in units of " << frame.restoredLength(1.0) << ", ";
  }
  message << "places are relative to " << frame.restoredPoint(Eigen::Vector3d::Zero()).transpose()
          << ")";
  throw Error(message.str());
}

} // namespace flattening
