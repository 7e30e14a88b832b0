// SPDX-License-Identifier: GPL-3.0-or-later
#include "Intrinsic/SymmetricTrapezoid.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace flattening
{
namespace
{

bool isOnMirror(long double logCrossing)
{
  return std::isinf(logCrossing);
}

// Half the crossing lengths in units of the edge. The angles of narrow cells depend on the last digits
// of their difference.
struct Halves
{
  long double Origin;
  long double Tip;
  long double Difference; // Origin - Tip, without cancellation
};

Halves halves(const SymmetricTrapezoid& cell)
{
  const long double origin = 0.5L * std::exp(cell.LogAtOrigin - cell.LogEdge);
  const long double tip = 0.5L * std::exp(cell.LogAtTip - cell.LogEdge);
  long double difference = origin - tip;
  if (origin > 0.0L && tip > 0.0L)
  {
    const long double ratio = cell.LogAtOrigin - cell.LogAtTip;
    difference = ratio > 0.0L ? -origin * std::expm1(-ratio) : tip * std::expm1(ratio);
  }
  return { origin, tip, difference };
}

long double logSum(std::initializer_list<long double> logs)
{
  const long double largest = std::max(logs);
  long double sum = 0.0L;
  for (const long double log : logs)
  {
    sum += std::exp(log - largest);
  }
  return largest + std::log(sum);
}

// The logarithm of the trapezoid's diagonal d, by Ptolemy's theorem: d^2 = e^2 + h h', with the crossing
// lengths h and h'.
long double logDiagonal(const SymmetricTrapezoid& cell)
{
  return 0.5L * logSum({ 2.0L * cell.LogEdge, cell.LogAtOrigin + cell.LogAtTip });
}

} // namespace

TrapezoidShape trapezoidShape(const SymmetricTrapezoid& cell)
{
  const Halves h = halves(cell);
  const long double cosine = std::clamp(h.Difference, -1.0L, 1.0L);
  const long double sine = std::sqrt((1.0L - cosine) * (1.0L + cosine));
  TrapezoidShape shape;
  shape.Degenerate = !(sine > 0.0L);
  // Measured from the crossing edge, or on the mirror from the mirror line.
  const auto slant = static_cast<double>(std::asin(cosine));
  shape.AngleAtOrigin = isOnMirror(cell.LogAtOrigin) ? -slant : 0.5 * EIGEN_PI - slant;
  shape.AngleAtTip = isOnMirror(cell.LogAtTip) ? slant : 0.5 * EIGEN_PI + slant;
  shape.Cotangent = shape.Degenerate ? 0.0 : static_cast<double>((h.Origin + h.Tip) / sine);
  shape.Extent = static_cast<double>(sine);
  return shape;
}

double cosineOppositeEdge(const SymmetricTrapezoid& cell)
{
  const Halves h = halves(cell);
  return static_cast<double>((h.Origin + h.Tip) / std::sqrt(1.0L + 4.0L * h.Origin * h.Tip));
}

double cosineOppositeCrossing(const SymmetricTrapezoid& cell)
{
  const Halves h = halves(cell);
  return static_cast<double>(
    (1.0L - 2.0L * h.Origin * h.Difference) / std::sqrt(1.0L + 4.0L * h.Origin * h.Tip));
}

long double crossingAtApex(const SymmetricTrapezoid& cell,
  long double logOriginApex,
  long double logTipApex)
{
  return logSum({ 2.0L * logOriginApex + cell.LogAtTip,
           std::log(2.0L) + logOriginApex + logTipApex + logDiagonal(cell),
           2.0L * logTipApex + cell.LogAtOrigin }) -
         2.0L * cell.LogEdge;
}

long double edgeAcross(const SymmetricTrapezoid& before, const SymmetricTrapezoid& after)
{
  return logSum({ before.LogEdge + logDiagonal(after), after.LogEdge + logDiagonal(before) }) -
         before.LogAtTip;
}

} // namespace flattening
