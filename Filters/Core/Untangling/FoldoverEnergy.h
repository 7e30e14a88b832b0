// SPDX-License-Identifier: GPL-3.0-or-later
/// An energy that measures how far a flat triangle is from its target, finite for flipped triangles too.
#pragma once

#include "Untangling/TargetTriangles.h"

namespace flattening
{

/// With J the linear map from the target triangle to the flat one, D = det J:
///   |J|^2 / chi(D) + areaWeight (D^2 + 1) / chi(D),  chi(D) = (D + sqrt(epsilon^2 + D^2)) / 2.
/// The first term is the inverse mean ratio, which asks for the target's shape; the second asks for its
/// area. As epsilon goes to 0, the energy of a flipped triangle goes to infinity (Garanzha, Kaporin,
/// Kudryavtseva, Protais, Ray, Sokolov, "Foldover-free maps in 50 lines of code", SIGGRAPH 2021).
class FoldoverEnergy
{
public:
  /// @p areaWeight >= 0.
  FoldoverEnergy(const TargetTriangle& target, double areaWeight);

  /// Row k is the position of corner k.
  using Corners = Eigen::Matrix<double, 3, 2>;

  /// D: signed area of the flat triangle over the area of the target.
  double areaRatio(const Corners& corners) const;

  /// @p epsilon >= 0; infinite if epsilon = 0 and D <= 0.
  double value(const Corners& corners, double epsilon) const;

  struct Derivatives
  {
    Eigen::Matrix<double, 6, 1> Gradient; ///< entry 2 k + c: by coordinate c of corner k
    /// The second derivatives of the energy by the entries of J, replaced by the nearest positive
    /// semidefinite matrix and then transformed to the coordinates of the corners.
    Eigen::Matrix<double, 6, 6> Hessian;
  };
  /// @p epsilon >= 0, and > 0 if D <= 0.
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
