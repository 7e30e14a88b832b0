// SPDX-License-Identifier: GPL-3.0-or-later
/// Gaussian-weighted means over balls in space around every point of a set.
#pragma once

#include "Base/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

namespace flattening
{

/// Points in space with a mass and a value.
struct WeightedPoints
{
  Points3 Positions;        ///< n x 3, input units
  Eigen::VectorXd Mass;     ///< n, >= 0: weight of each point in the means
  Eigen::VectorXd Integral; ///< n: value of each point times its mass
};

/// The mean value around each point v (n): sum_x Integral_x g(x) / sum_x Mass_x g(x), with
/// g(x) = exp(-|x - v|^2 / (2 s^2)) over the ball |x - v| < 2 s; 0 if the ball has no mass. The means
/// are computed in single precision, with an error of about 1e-5 of the largest value, by all threads;
/// the result does not depend on their number.
///
/// @param deviation the standard deviation s, input units, > 0.
/// @param spacing side of the cubic cells whose points are taken together at their centre of mass, in
/// units of s, so that the time does not depend on the number of points in a ball; 0: no cells.
/// @throws InvalidInput if @p deviation is not positive, or so small that the points extend over more
/// than about 260,000 deviations.
Eigen::VectorXd gaussianMeans(const WeightedPoints& points,
  double deviation,
  double spacing,
  const ProgressCallback& progress = {});

} // namespace flattening
