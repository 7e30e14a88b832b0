// SPDX-License-Identifier: GPL-3.0-or-later
/// Gaussian-weighted means over balls in space, at every point of a set.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{

/// Sums over the points around a point: a mean is Integral / Mass.
struct WeightedPoints
{
  Points3 Positions;        ///< n x 3, input units
  Eigen::VectorXd Mass;     ///< n, >= 0: what each point counts
  Eigen::VectorXd Integral; ///< n: its value times its mass
};

/// For each point v (n): sum_x Integral_x g(x) / sum_x Mass_x g(x), with g(x) = exp(-|x - v|^2 / (2
/// s^2)) over the ball |x - v| < 2 s; 0 where no mass is near. Computed in single precision, with a
/// relative error of about 1e-5 of the largest value, by all threads; the result does not depend on
/// their number.
///
/// @param spacing with more than 0, points in the same cubic cell of spacing times s count together at
/// their centre of mass, so that the time does not depend on the number of points in a ball.
/// @throws InvalidInput if @p deviation is not positive, or less than a millionth of the points' extent.
Eigen::VectorXd gaussianMeans(const WeightedPoints& points,
  double deviation,
  double spacing,
  const ProgressCallback& progress = {});

} // namespace flattening
