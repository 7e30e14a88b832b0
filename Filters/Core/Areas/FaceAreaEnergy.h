// SPDX-License-Identifier: GPL-3.0-or-later
/// What a flat face costs whose area is not its target, finite for flipped faces too.
#pragma once

#include <Eigen/Core>

namespace flattening
{

/// For r the ratio of the flat area to the target T, chi = (r + sqrt(epsilon^2 + r^2)) / 2 (r itself for
/// epsilon = 0), and q the flat triangle's Dirichlet energy on the surface triangle, which is its area
/// where the two are similar and larger everywhere else:
///   T ((r - 1)^2 + beta (chi - 1 - log chi) + s log(chi(q / T) / chi)).
/// The first term asks for the area. The second keeps the face from flipping: without limit for
/// epsilon = 0. The third, with the shape weight s, asks for the surface triangle's angles; by its
/// logarithm it lets go of faces that must be stretched far.
class FaceAreaEnergy
{
public:
  struct Options
  {
    double Epsilon = 0.0;     ///< >= 0, of the target area
    double FlipWeight = 0.03; ///< beta, > 0
  };

  struct Value
  {
    double Energy = 0.0; ///< infinite if epsilon = 0 and the face is flipped
    double ByArea = 0.0;
    double ByDirichlet = 0.0;
    double Curvature = 0.0; ///< second derivative by the area, its positive part
  };

  FaceAreaEnergy() = default;
  explicit FaceAreaEnergy(const Options& options)
    : Epsilon(options.Epsilon)
    , FlipWeight(options.FlipWeight)
  {
  }

  /// @p area is signed, @p target > 0, @p dirichlet >= 0, @p shapeWeight >= 0. Areas in one unit.
  Value value(double area, double target, double dirichlet, double shapeWeight) const;

private:
  double Epsilon = 0.0;
  double FlipWeight = 0.0;
};

} // namespace flattening
