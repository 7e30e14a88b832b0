// SPDX-License-Identifier: GPL-3.0-or-later
/// The cuts by which a surface becomes a disk.
#pragma once

#include "Base/Progress.h"
#include "Disk/SurfaceToDisk.h"

#include <Eigen/Core>

#include <optional>

namespace flattening
{

/// The boundaries of a surface that is to be opened.
struct OpenEnds
{
  enum class Kind
  {
    None, ///< the surface is closed
    One,  ///< which becomes that of the disk
    Two   ///< the surface is a tube, kept with both ends until a seam joins them
  };
  Kind Ends = Kind::None;
  /// Where a boundary was that is too short to become that of the disk (isPuncture), and is filled.
  std::optional<Eigen::Vector3d> Puncture;
};

/// Makes a disk of @p disk's surface, connected, oriented, with handles only if these are to be cut:
/// cuts along handles, a hole or a seam, as @p options say, and resolves the boundary. Adds to the
/// report what was cut. @throws InvalidInput if points for the cuts are not on the surface, Cancelled.
void openSurface(DiskSurface& disk,
  const OpenEnds& ends,
  const SurfaceToDiskOptions& options,
  const ProgressCallback& progress);

} // namespace flattening
