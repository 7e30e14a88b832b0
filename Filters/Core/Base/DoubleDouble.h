// SPDX-License-Identifier: GPL-3.0-or-later
/// Numbers of twice the precision of double.
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace flattening
{

/// The unevaluated sum of two doubles, the second at most half a unit in the last place of the first:
/// 106 bits, and a relative error of an operation of about 1e-31 (Dekker 1971, "A floating-point
/// technique for extending the available precision"; Hida, Li, Bailey 2001, "Algorithms for quad-double
/// precision arithmetic"). Numbers must be finite.
///
/// The type is the project's own because long double has too few digits, quadruple precision is emulated
/// in software, the Boost of the supported systems has no type of two doubles, and the few operations
/// needed are not worth a dependency on the library QD.
class DoubleDouble
{
public:
  DoubleDouble() = default;
  DoubleDouble(double value) // NOLINT(google-explicit-constructor): the conversion is exact
    : High(value)
  {
  }

  /// The exact sum.
  static DoubleDouble sum(double a, double b)
  {
    const double high = a + b;
    const double part = high - a;
    return { high, (a - (high - part)) + (b - part) };
  }
  /// The exact product.
  static DoubleDouble product(double a, double b)
  {
    const double high = a * b;
    return { high, std::fma(a, b, -high) };
  }

  double high() const { return this->High; }
  double low() const { return this->Low; }
  explicit operator double() const { return this->High; }

  DoubleDouble operator-() const { return { -this->High, -this->Low }; }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b)
  {
    const DoubleDouble high = sum(a.High, b.High);
    const DoubleDouble low = sum(a.Low, b.Low);
    const DoubleDouble both = normalized(high.High, high.Low + low.High);
    return normalized(both.High, both.Low + low.Low);
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b)
  {
    const DoubleDouble high = product(a.High, b.High);
    return normalized(high.High, high.Low + (a.High * b.Low + a.Low * b.High));
  }
  DoubleDouble& operator+=(const DoubleDouble& other) { return *this = *this + other; }
  DoubleDouble& operator-=(const DoubleDouble& other) { return *this = *this - other; }
  DoubleDouble& operator*=(const DoubleDouble& other) { return *this = *this * other; }

  friend bool operator==(const DoubleDouble& a, const DoubleDouble& b)
  {
    return a.High == b.High && a.Low == b.Low;
  }
  friend bool operator!=(const DoubleDouble& a, const DoubleDouble& b) { return !(a == b); }
  friend bool operator<(const DoubleDouble& a, const DoubleDouble& b)
  {
    return a.High < b.High || (a.High == b.High && a.Low < b.Low);
  }

  /// Square root of @p value >= 0: one Newton step from that of double.
  friend DoubleDouble sqrt(const DoubleDouble& value)
  {
    const double root = std::sqrt(value.High);
    if (!(root > 0.0))
    {
      return 0.0;
    }
    return normalized(root, (value - product(root, root)).High / (2.0 * root));
  }

private:
  DoubleDouble(double high, double low)
    : High(high)
    , Low(low)
  {
  }
  // The same sum with the greatest possible first part. Precondition: |low| <= |high|.
  static DoubleDouble normalized(double high, double low)
  {
    const double total = high + low;
    return { total, low - (total - high) };
  }

  double High = 0.0;
  double Low = 0.0;
};

} // namespace flattening

namespace Eigen
{

template <>
struct NumTraits<flattening::DoubleDouble> : GenericNumTraits<flattening::DoubleDouble>
{
  enum
  {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 20,
    MulCost = 10
  };
};

} // namespace Eigen
