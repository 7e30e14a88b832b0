// SPDX-License-Identifier: GPL-3.0-or-later
/// From the half-plane to the disk, and which of the disk's Moebius images to take.
#pragma once

#include "Mesh/ComplexPositions.h"

namespace flattening
{

/// (z - centre) / (z - conj(centre)): the upper half-plane onto the unit disk, centre to 0 and infinity
/// to 1. Infinite entries of @p halfPlane are allowed.
ComplexVector cayley(const ComplexVector& halfPlane, std::complex<double> centre);

/// The point of the half-plane that the Cayley map must send to 0 so that the images have their centre
/// of mass at 0: sum_i mass_i m(z_i) = 0 (mathematics.md, "Measures"; the conformal barycentre). Unique
/// if no point on the boundary carries half of the mass. @p masses >= 0, one per point.
/// @throws ConvergenceError if Newton's method does not end.
std::complex<double> centreOfMass(const ComplexVector& halfPlane, const Eigen::VectorXd& masses);

/// The angle (radians) by which to rotate the disk so that its orientation depends on the surface alone,
/// not on its numbering or its place in space: the direction in which, by mass, the points far from the
/// surface's centroid lie. Returns false if the surface is too symmetric to have one.
bool intrinsicRotation(const ComplexVector& disk,
  const Points3& surface,
  const Eigen::VectorXd& masses,
  double& angle);

} // namespace flattening
