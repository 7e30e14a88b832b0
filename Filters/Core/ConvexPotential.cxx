// SPDX-License-Identifier: GPL-3.0-or-later
#include "ConvexPotential.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace flattening
{

Eigen::VectorXd radialPotentialWeights(const Points2& sites, const Eigen::VectorXd& masses)
{
  const int n = static_cast<int>(sites.rows());
  const Eigen::VectorXd radii = sites.rowwise().norm();
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(),
    order.end(),
    [&radii](int a, int b) { return radii[a] != radii[b] ? radii[a] < radii[b] : a < b; });

  // Between two radii sqrt(m) runs linearly, which keeps h strictly convex and its integral exact.
  const double total = masses.sum();
  Eigen::VectorXd weights(n);
  double mass = 0.0;
  double slope = 0.0;
  double height = 0.0;
  double radius = 0.0;
  for (const int i : order)
  {
    mass += masses[i];
    const double nextSlope = std::sqrt(mass / total);
    height += 0.5 * (slope + nextSlope) * (radii[i] - radius);
    slope = nextSlope;
    radius = radii[i];
    weights[i] = radius * radius - 2.0 * height;
  }
  return weights;
}

} // namespace flattening
