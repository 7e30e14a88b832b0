// SPDX-License-Identifier: GPL-3.0-or-later
#include "HornSpreading.h"

#include "SpringLayout.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flattening
{
namespace
{

// Of the mean scale: -log(1e5).
constexpr double HornLogScale = -11.512925464970229;
// On a tube of radius a, springs of weight s^p make a harmonic map fall like exp(-k x / a) instead of
// the conformal scale s = exp(-x / a), k = sqrt(1 + p^2 / 4) - p / 2.
constexpr double SpringPower = 4.0;

int spread(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& metric,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& disk)
{
  std::vector<double> depth(t.vertexCount(), 0.0);
  std::vector<char> fixed(t.vertexCount(), 1);
  for (int h = 0; h < t.halfedgeCount(); ++h)
  {
    fixed[t.origin(h)] = 0;
  }
  for (const auto& edge : t.boundaryEdges())
  {
    if (edge.Origin >= 0)
    {
      fixed[edge.Origin] = 1;
    }
  }
  int count = 0;
  for (int v = 0; v < t.vertexCount(); ++v)
  {
    depth[v] = std::min(0.0, static_cast<double>(logFactors[v]) - logMeanFactor - HornLogScale);
    count += !fixed[v] && depth[v] < 0.0;
  }
  if (count > 0)
  {
    std::vector<Spring> springs = springsOf(t, metric);
    for (Spring& s : springs)
    {
      s.Weight *= std::exp(0.5 * SpringPower * (depth[s.From] + depth[s.To]));
    }
    relaxSprings(springs, fixed, disk);
  }
  return count;
}

} // namespace

int spreadHorns(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& disk)
{
  return spread(t, logFactors, logFactors, logMeanFactor, disk);
}

int spreadHornsInOwnMetric(const IntrinsicTriangulation& t,
  const IntrinsicTriangulation::Factors& logFactors,
  double logMeanFactor,
  ComplexVector& disk)
{
  const IntrinsicTriangulation::Factors none = IntrinsicTriangulation::Factors::Zero(t.vertexCount());
  return spread(t, none, logFactors, logMeanFactor, disk);
}

} // namespace flattening
