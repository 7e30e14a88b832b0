// SPDX-License-Identifier: GPL-3.0-or-later
/// Points that a user picked on a surface.
#pragma once

#include "Mesh/ClosestPointTree.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <string>

namespace flattening
{

/// The diagonal of the bounding box of the vertices, input units.
double boxDiagonal(const TriangleMesh& mesh);

/// The point of the surface nearest to @p picked (input units).
/// @param diagonal of the surface (boxDiagonal)
/// @param what names the point in messages, such as "the hole's point".
/// @throws InvalidInput if a coordinate is not finite or the surface is farther away than 5 % of the
/// diagonal of its bounding box: then the point was meant for another surface or never set.
SurfacePoint pickOnSurface(const ClosestPointTree& surface,
  double diagonal,
  const Eigen::Vector3d& picked,
  const std::string& what);

} // namespace flattening
