// SPDX-License-Identifier: GPL-3.0-or-later
/// Vectors of the plane.
#pragma once

#include <Eigen/Core>

namespace flattening
{

/// The z component of the cross product: twice the signed area of the triangle 0, @p a, @p b.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

} // namespace flattening
