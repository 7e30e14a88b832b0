// SPDX-License-Identifier: GPL-3.0-or-later
/// The angles of a triangle from the logarithms of its sides' lengths, which may be of any magnitude.
#pragma once

namespace flattening
{

/// The angles (radians) opposite to the sides. Where the triangle inequality fails, the angle opposite
/// to the longest side is pi and the others are 0: the C1 extension of the convex energy (Bobenko,
/// Pinkall, Springborn 2015).
struct TriangleAngles
{
  double Angle[3];
  double Cotangent[3]; ///< 0 where the triangle is degenerate
  bool Degenerate;
};
/// The angles of the triangle with sides of lengths exp(logA), exp(logB), exp(logC), in this order.
TriangleAngles triangleAngles(long double logA, long double logB, long double logC);

/// Cosine of the angle opposite to the side of length exp(opposite), where exp(left) and exp(right) are
/// the other sides; outside [-1, 1] where the triangle inequality fails.
double cosineOpposite(long double opposite, long double left, long double right);

} // namespace flattening
