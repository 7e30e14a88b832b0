// SPDX-License-Identifier: GPL-3.0-or-later
/// A smooth, positive stand-in for an area ratio, by which energies stay finite for flipped faces.
#pragma once

#include <cmath>

namespace flattening
{

/// chi(x) = (x + sqrt(epsilon^2 + x^2)) / 2, which is nearly x for x > 0 and nearly 0 for x < 0
/// (Garanzha et al. 2021; see FoldoverEnergy.h). Its derivative is Value / Root.
struct SmoothPositivePart
{
  double Root;  ///< sqrt(epsilon^2 + x^2)
  double Value; ///< chi(x)
};

/// @p epsilon >= 0. The value is 0 if epsilon is 0 and x <= 0, and positive otherwise.
inline SmoothPositivePart smoothPositivePart(double x, double epsilon)
{
  const double root = std::sqrt(epsilon * epsilon + x * x);
  if (x > 0.0)
  {
    return { root, 0.5 * (x + root) };
  }
  // The same without the cancellation of x against the root.
  return { root, epsilon > 0.0 ? 0.5 * epsilon * epsilon / (root - x) : 0.0 };
}

} // namespace flattening
