// SPDX-License-Identifier: GPL-3.0-or-later
/// Disks that span a closed loop, and what becomes of a surface that is cut there and closed by two.
#pragma once

#include "Handles/FaceIntersections.h"
#include "Handles/TracedSurface.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace flattening
{

/// A triangulated disk. Vertices are numbered from 0: those of the loop first, in its direction, then
/// those inside.
struct LoopCap
{
  std::vector<Eigen::Vector3d> Inside;
  /// Per inner vertex: the weights of the loop's vertices that it is made of; sum 1.
  std::vector<TracedSurface::Origin> Weights;
  std::vector<std::array<int, 3>> Faces; ///< with the loop's sides in its direction
};

/// The triangulation of least dihedral angles and area (Liepa 2003; CGAL triangulate_hole_polyline),
/// refined to the length of the loop's sides (CGAL refine). Empty if there is none.
LoopCap spanningCap(const std::vector<Eigen::Vector3d>& loop);

/// A cone over the loop, remeshed to the mean length of its sides (CGAL isotropic_remeshing) unless a
/// face of the cone has no area.
LoopCap coneCap(const std::vector<Eigen::Vector3d>& loop);

/// Splits the edges inside the cap that join two neighbours in the surface: there would be two edges
/// between the same vertices. @p vertices are those of the loop in the surface.
void splitEdgesOf(const HalfedgeSurface& surface,
  const std::vector<int>& vertices,
  const std::vector<Eigen::Vector3d>& loop,
  LoopCap& cap);

/// A surface after a cut along a loop and the closing of both sides.
struct CappedCut
{
  std::vector<int> Vertices; ///< of the loop
  LoopCap Cap;
  /// Numbers of new vertices: copies of the loop's for the side on its left, inner vertices of the cap
  /// on the right, of that on the left.
  int FirstCopy = 0;
  int FirstRight = 0;
  int FirstLeft = 0;
  FaceReplacement Faces; ///< first those that meet the loop, in the order of Replaced, then the caps
};

/// Both copies of the loop's vertices move by @p step of the way to the centre of area of the faces
/// around them, each on its side, and the caps with them, so that they come apart.
CappedCut capBothSides(const HalfedgeSurface& surface,
  const std::vector<int>& loop,
  const LoopCap& cap,
  double step);

} // namespace flattening
