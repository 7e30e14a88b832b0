// SPDX-License-Identifier: GPL-3.0-or-later
/// Triangulated disks (caps) that span a closed loop.
#pragma once

#include "Handles/HalfedgeSurface.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace flattening
{

/// A triangulated disk. Its vertices are numbered from 0: first those of the loop, in its direction,
/// then those inside.
struct LoopCap
{
  std::vector<Eigen::Vector3d> Inside; ///< positions of the inner vertices
  /// Per inner vertex: the weights of the loop's vertices that it is made of; sum 1.
  std::vector<Origin> Weights;
  std::vector<std::array<int, 3>> Faces; ///< with the loop's sides in its direction
};

/// The triangulation of least dihedral angles and area (Liepa 2003, "Filling holes in meshes"; CGAL
/// triangulate_hole_polyline), refined to the length of the loop's sides (CGAL refine). The same loop
/// always gets the same cap. Empty if there is none, or if the loop has more than LongestSearchedLoop
/// vertices.
LoopCap spanningCap(const std::vector<Eigen::Vector3d>& loop);

/// A cone over the loop: faces from its sides to its centre, which fit any loop.
LoopCap coneCap(const std::vector<Eigen::Vector3d>& loop);

/// Splits the edges inside the cap whose ends are neighbours in the surface already: there would be two
/// edges between the same vertices. @p vertices are those of the loop in the surface.
void splitEdgesOf(const HalfedgeSurface& surface,
  const std::vector<int>& vertices,
  const std::vector<Eigen::Vector3d>& loop,
  LoopCap& cap);

} // namespace flattening
