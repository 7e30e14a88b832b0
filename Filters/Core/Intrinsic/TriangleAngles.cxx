// SPDX-License-Identifier: GPL-3.0-or-later
#include "Intrinsic/TriangleAngles.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{

// A triangle is computed in extended precision if two sides exceed the third by less than this share of
// the smaller one. The error of an angle near pi is that of the excess, about 1e-16, divided by its
// square root: at 1e-4 some 1e-14, far below the tolerances of all callers. A smaller bound loses
// digits, a larger one time.
constexpr double NarrowExcess = 1e-4;

// Returns whether the digits of Real sufficed.
template <typename Real>
bool anglesInPrecision(const long double (&log)[3], TriangleAngles& result)
{
  const long double unit = std::max({ log[0], log[1], log[2] });
  Real side[3];
  for (int k = 0; k < 3; ++k)
  {
    side[k] = std::exp(static_cast<Real>(log[k] - unit));
  }
  // How far the sum of the other two sides exceeds side k, with the nearly equal pair of a needle
  // subtracted as logarithms.
  Real excess[3];
  bool wide = true;
  for (int k = 0; k < 3; ++k)
  {
    int near = (k + 1) % 3;
    int other = (k + 2) % 3;
    if (std::abs(log[other] - log[k]) < std::abs(log[near] - log[k]))
    {
      std::swap(near, other);
    }
    excess[k] = side[other] - side[near] * std::expm1(static_cast<Real>(log[k] - log[near]));
    wide = wide && excess[k] > static_cast<Real>(NarrowExcess) * std::min(side[near], side[other]);
  }
  result.Degenerate = false;
  for (int k = 0; k < 3; ++k)
  {
    if (!(excess[k] > 0))
    {
      result.Degenerate = true;
      for (int j = 0; j < 3; ++j)
      {
        result.Angle[j] = j == k ? EIGEN_PI : 0.0;
        result.Cotangent[j] = 0.0;
      }
      return wide;
    }
  }
  const Real perimeter = side[0] + side[1] + side[2];
  const Real fourArea = std::sqrt(perimeter * excess[0] * excess[1] * excess[2]);
  for (int k = 0; k < 3; ++k)
  {
    const Real b = excess[(k + 1) % 3];
    const Real c = excess[(k + 2) % 3];
    result.Angle[k] =
      static_cast<double>(2 * std::atan2(std::sqrt(b * c), std::sqrt(perimeter * excess[k])));
    const Real l = side[(k + 1) % 3];
    const Real r = side[(k + 2) % 3];
    result.Cotangent[k] = static_cast<double>((l * l + r * r - side[k] * side[k]) / fourArea);
  }
  return wide;
}

// If all sides and excesses are above this share of the longest side, no more than a digit or two are
// lost to cancellation. A smaller bound loses more, a larger one time.
constexpr double WellShaped = 0.1;

// Computes the same without precautions, three times as fast. Returns whether they were unnecessary.
bool anglesOfWellShaped(const long double (&log)[3], TriangleAngles& result)
{
  const long double unit = std::max({ log[0], log[1], log[2] });
  double side[3];
  for (int k = 0; k < 3; ++k)
  {
    side[k] = log[k] == unit ? 1.0 : std::exp(static_cast<double>(log[k] - unit));
  }
  const double excess[3] = {
    side[1] + side[2] - side[0], side[2] + side[0] - side[1], side[0] + side[1] - side[2]
  };
  if (!(std::min({ side[0], side[1], side[2], excess[0], excess[1], excess[2] }) > WellShaped))
  {
    return false;
  }
  const double squared[3] = { side[0] * side[0], side[1] * side[1], side[2] * side[2] };
  const double fourArea = std::sqrt((side[0] + side[1] + side[2]) * excess[0] * excess[1] * excess[2]);
  const double twiceDot[3] = { squared[1] + squared[2] - squared[0],
    squared[2] + squared[0] - squared[1],
    squared[0] + squared[1] - squared[2] };
  result.Degenerate = false;
  result.Angle[0] = std::atan2(fourArea, twiceDot[0]);
  result.Angle[1] = std::atan2(fourArea, twiceDot[1]);
  result.Angle[2] = EIGEN_PI - result.Angle[0] - result.Angle[1];
  for (int k = 0; k < 3; ++k)
  {
    result.Cotangent[k] = twiceDot[k] / fourArea;
  }
  return true;
}

} // namespace

double cosineOpposite(long double opposite, long double left, long double right)
{
  const double x = std::exp(static_cast<double>(left - opposite));
  const double y = std::exp(static_cast<double>(right - opposite));
  return (x * x + y * y - 1.0) / (2.0 * x * y);
}

TriangleAngles triangleAngles(long double logA, long double logB, long double logC)
{
  const long double log[3] = { logA, logB, logC };
  TriangleAngles result;
  if (!anglesOfWellShaped(log, result) && !anglesInPrecision<double>(log, result))
  {
    anglesInPrecision<long double>(log, result);
  }
  return result;
}

} // namespace flattening
