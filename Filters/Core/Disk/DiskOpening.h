// SPDX-License-Identifier: GPL-3.0-or-later
/// The cuts that make a disk of a connected surface: a hole, a seam, or a graph along its handles.
#pragma once

#include "Base/Progress.h"
#include "Disk/SurfaceToDiskOptions.h"

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
    One,  ///< there is one boundary, and it becomes the boundary of the disk
    Two   ///< the surface is a tube, which keeps both ends until a seam joins them
  };
  Kind Ends = Kind::None;
  /// The centre of a boundary that was filled because it was too short to become that of the disk
  /// (isPuncture): the hole is cut there, unless another point is given.
  std::optional<Eigen::Vector3d> Puncture;
};

/// Cuts a connected, oriented surface open to a disk: by a hole or a seam, as @p options say, and along
/// a cut graph if the surface has handles that are kept. Adds vertices to a boundary that has too few,
/// and adds the cuts to the report.
/// @throws InvalidInput if points for the cuts are not on the surface; TopologyError if a cut is not
/// possible there; Cancelled.
void openSurface(DiskSurface& disk,
  const OpenEnds& ends,
  const SurfaceToDiskOptions& options,
  const ProgressCallback& progress);

} // namespace flattening
