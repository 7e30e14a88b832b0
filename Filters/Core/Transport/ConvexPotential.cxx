// SPDX-License-Identifier: GPL-3.0-or-later
#include "Transport/ConvexPotential.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace flattening
{

PowerDiagram::Weights squaredRadii(const Points2& sites)
{
  PowerDiagram::Weights squares(sites.rows());
  for (Eigen::Index i = 0; i < sites.rows(); ++i)
  {
    squares[i] =
      DoubleDouble::product(sites(i, 0), sites(i, 0)) + DoubleDouble::product(sites(i, 1), sites(i, 1));
  }
  return squares;
}

PowerDiagram::Weights radialPotentialWeights(const Points2& sites,
  const Eigen::VectorXd& masses,
  double reach)
{
  const int n = static_cast<int>(sites.rows());
  const PowerDiagram::Weights squares = squaredRadii(sites);
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(),
    order.end(),
    [&squares](int a, int b) { return squares[a] != squares[b] ? squares[a] < squares[b] : a < b; });

  // Between two radii sqrt(m) runs linearly, which keeps h strictly convex and its integral exact.
  const double total = masses.sum();
  PowerDiagram::Weights weights(n);
  double mass = 0.0;
  double slope = 0.0;
  DoubleDouble height = 0.0;
  DoubleDouble radius = 0.0;
  for (const int i : order)
  {
    mass += masses[i];
    const double nextSlope = std::sqrt(mass / total);
    const DoubleDouble nextRadius = sqrt(squares[i]);
    height += DoubleDouble(0.5 * (slope + nextSlope)) * (nextRadius - radius);
    slope = nextSlope;
    radius = nextRadius;
    weights[i] = squares[i] - DoubleDouble(2.0 * reach) * height;
  }
  return weights;
}

} // namespace flattening
