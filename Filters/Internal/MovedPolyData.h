// SPDX-License-Identifier: GPL-3.0-or-later
/// A surface moved to other coordinates.
#pragma once

#include <Eigen/Geometry>

class vtkPolyData;

namespace flattening
{

/// Moves the points, in double precision, and turns the point and cell arrays `Normals` along, together
/// with the active normals. If the transform mirrors, the cells are reversed, so that the surface keeps
/// its outside, and triangle strips become triangles.
void movePolyData(vtkPolyData* surface, const Eigen::Affine3d& transform);

} // namespace flattening
