// SPDX-License-Identifier: GPL-3.0-or-later
/// How far a flat triangle is from its target, finite for flipped triangles too.
#pragma once

#include "Untangling/TargetTriangles.h"

namespace flattening
{

/// With J the linear map from the target triangle to the flat one, D = det J:
///   |J|^2 / chi(D) + areaWeight (D^2 + 1) / chi(D),  chi(D) = (D + sqrt(epsilon^2 + D^2)) / 2,
/// the inverse mean ratio, which asks for the target's shape, and a term that asks for its area. As
/// epsilon goes to 0, the energy of a triangle that is flipped goes to infinity (Garanzha, Kaporin,
/// Kudryavtseva, Protais, Ray, Sokolov, "Foldover-free maps in 50 lines of code", SIGGRAPH 2021).
class FoldoverEnergy
{
public:
  /// @p areaWeight >= 0.
  FoldoverEnergy(const TargetTriangle& target, double areaWeight);

  /// Row k is the place of corner k.
  using Corners = Eigen::Matrix<double, 3, 2>;

  /// D: signed area of the flat triangle over that of the target.
  double areaRatio(const Corners& corners) const;

  /// @p epsilon >= 0; infinite if epsilon = 0 and D <= 0.
  double value(const Corners& corners, double epsilon) const;

  struct Derivatives
  {
    Eigen::Matrix<double, 6, 1> Gradient; ///< entry 2 k + c: by coordinate c of corner k
    Eigen::Matrix<double, 6, 6> Hessian;  ///< nearest positive semidefinite one, in terms of J
  };
  Derivatives derivatives(const Corners& corners, double epsilon) const;

private:
  Eigen::Matrix2d jacobian(const Corners& corners) const
  {
    return corners.transpose() * this->Gradients;
  }

  Eigen::Matrix<double, 3, 2> Gradients; // of the corners' hat functions on the target
  double AreaWeight;
};

} // namespace flattening
