// SPDX-License-Identifier: GPL-3.0-or-later
/// The energy of a flat face by its area and shape; it may be finite for flipped faces.
#pragma once

#include <limits>

namespace flattening
{

/// The energy of a face with target area T is
///   c T (w (r - 1)^2 + beta (chi(r) - 1 - log chi(r)) + s D(chi(q / T) / chi(r))).
/// Here r is the flat area over T, chi(r) = (r + sqrt(epsilon^2 + r^2)) / 2 a smooth positive part (r
/// for epsilon = 0 and r > 0; Garanzha et al. 2021), and q the Dirichlet energy of the flat triangle on
/// the surface triangle: the flat area if the two are similar, and more otherwise. The first term asks
/// for the area, with the area weight w. The second keeps the face from flipping, without limit for
/// epsilon = 0. The third, with the shape weight s, asks for the surface triangle's angles: D(x) is
/// log x up to the shape limit l, and log l + x / l - 1 beyond it. Because of its logarithm it lets go
/// of faces that must be stretched far; the limit holds those that need not be (docs/mathematics.md,
/// "From cells to faces", "A free outline"). The count c is 1 unless area weights are given
/// (faceCounts).
class FaceAreaEnergy
{
public:
  struct Value
  {
    double Energy = 0.0;      ///< infinite if epsilon = 0 and the face is flipped
    double ByArea = 0.0;      ///< derivative by the area
    double ByDirichlet = 0.0; ///< derivative by the Dirichlet energy
    double Curvature = 0.0;   ///< second derivative by the area, positive part
  };

  /// beta. A choice by trial: areas of regions suffer from more, with less faces come near to flipping.
  static constexpr double FlipWeight = 0.03;

  /// @p epsilon >= 0, in target areas: how smooth the barrier against flipping is.
  explicit FaceAreaEnergy(double epsilon)
    : Epsilon(epsilon)
  {
  }

  /// The weights of a face.
  struct Weights
  {
    double Area = 1.0;                                           ///< w, > 0
    double Shape = 0.0;                                          ///< s, >= 0
    double Count = 1.0;                                          ///< c, > 0
    double ShapeLimit = std::numeric_limits<double>::infinity(); ///< l, >= 1
  };
  /// @p area is signed, @p target > 0, @p dirichlet >= 0. Areas in one unit.
  Value value(double area, double target, double dirichlet, const Weights& weights) const;

private:
  double Epsilon;
};

} // namespace flattening
