// SPDX-License-Identifier: GPL-3.0-or-later
/// Lines that were drawn on a surface, as the paths of a seam.
#pragma once

#include <Eigen/Core>

#include <vector>

class vtkPolyData;

namespace flattening
{

struct SeamLines
{
  std::vector<Eigen::Vector3d> Points; ///< of all lines, one after the other
  std::vector<int> PathStarts;         ///< number of the first point of each line but the first
};

/// The lines of @p data. Coincident points are merged, and lines that meet at a point where no other one
/// ends are joined. Lines whose cell array SeamId is 0 or less are left out.
/// @throws InvalidInput if there is no line, or a point is not finite.
SeamLines seamLines(vtkPolyData* data);

} // namespace flattening
