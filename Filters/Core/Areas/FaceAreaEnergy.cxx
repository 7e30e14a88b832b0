// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/FaceAreaEnergy.h"

#include "Untangling/SmoothPositivePart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{

// The least Dirichlet energy, in target areas. A guard: the logarithm of 0 does not exist.
constexpr double LeastDirichlet = 1e-12;

} // namespace

FaceAreaEnergy::Value FaceAreaEnergy::value(double area,
  double target,
  double dirichlet,
  const Weights& weights) const
{
  Value result;
  const double r = area / target;
  const auto [root, chi] = smoothPositivePart(r, this->Epsilon);
  if (!(chi > 0.0))
  {
    result.Energy = std::numeric_limits<double>::infinity();
    return result;
  }
  const double logChi = std::log(chi);
  const double byLog = 1.0 / root; // derivative of log chi by r
  const double chiByR = chi * byLog;
  const double chiByRR = 0.5 * this->Epsilon * this->Epsilon * byLog * byLog * byLog;
  const double w = weights.Area;
  const double s = weights.Shape;
  const double c = weights.Count;
  // Smoothed like r, so that a face does not gain by shrinking to a point.
  const double q = std::max(dirichlet / target, LeastDirichlet);
  const SmoothPositivePart chiOfQ = smoothPositivePart(q, this->Epsilon);
  const double ratio = chiOfQ.Value / chi;
  const bool isBeyond = ratio > weights.ShapeLimit;
  const double excess = isBeyond ? ratio / weights.ShapeLimit : 1.0; // derivative of D by log x

  const double logRatio = isBeyond ? std::log(weights.ShapeLimit) : std::log(chiOfQ.Value) - logChi;
  const double shape = s > 0.0 ? s * (logRatio + excess - 1.0) : 0.0;
  result.Energy = c * target * (w * (r - 1.0) * (r - 1.0) + FlipWeight * (chi - 1.0 - logChi) + shape);
  result.ByArea = c * (2.0 * w * (r - 1.0) + FlipWeight * (chiByR - byLog) - s * excess * byLog);
  result.ByDirichlet = c * s * excess / chiOfQ.Root;
  // Minus the logarithm is concave where the face is flipped; only positive curvature counts.
  const double logCurvature = r * byLog * byLog * byLog;
  const double flipCurvature = std::max(0.0, chiByRR + logCurvature);
  const double shapeCurvature =
    isBeyond ? excess * (logCurvature + byLog * byLog) : std::max(0.0, logCurvature);
  result.Curvature = c * (2.0 * w + FlipWeight * flipCurvature + s * shapeCurvature) / target;
  return result;
}

} // namespace flattening
