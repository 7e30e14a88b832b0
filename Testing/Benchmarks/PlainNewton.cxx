// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlainNewton.h"

#include "Base/SparseFactorization.h"
#include "Yardstick.h"

#include <algorithm>
#include <vector>

namespace flattening::benchmarks
{
namespace
{

constexpr int MostHalvings = 40;

// Minus the derivative of all areas but the last by all weights but the last.
SparseMatrix jacobian(const PowerDiagram& diagram)
{
  const int n = diagram.siteCount() - 1;
  std::vector<Eigen::Triplet<double>> entries;
  for (const PowerDiagram::CommonSide& side : diagram.commonSides())
  {
    const double value = side.Length / (2.0 * side.Distance);
    const int i = std::max(side.First, side.Second);
    const int j = std::min(side.First, side.Second);
    entries.emplace_back(j, j, value);
    if (i < n)
    {
      entries.emplace_back(i, i, value);
      entries.emplace_back(i, j, -value);
    }
  }
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double cellError(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets)
{
  return ((areas - targets).array() / targets.array()).abs().maxCoeff();
}

} // namespace

PlainNewtonResult plainNewton(PowerDiagram& diagram,
  const Eigen::VectorXd& targets,
  double tolerance,
  double seconds)
{
  const StopWatch watch;
  const Eigen::Index n = targets.size();
  PowerDiagram::Weights weights = PowerDiagram::Weights::Zero(n);
  PlainNewtonResult result;
  if (!diagram.update(weights))
  {
    return result;
  }
  const double least = 0.5 * std::min(diagram.areas().minCoeff(), targets.minCoeff());
  result.CellError = cellError(diagram.areas(), targets);
  while (result.CellError > tolerance)
  {
    const Eigen::VectorXd gap = targets - diagram.areas();
    const SparseCholesky cholesky(jacobian(diagram));
    if (cholesky.info() != Eigen::Success)
    {
      return result;
    }
    Eigen::VectorXd step = Eigen::VectorXd::Zero(n);
    step.head(n - 1) = cholesky.solve(gap.head(n - 1));
    double length = 1.0;
    bool accepted = false;
    PowerDiagram::Weights next;
    for (int trial = 0; trial < MostHalvings && !accepted; ++trial)
    {
      if (watch.processorSeconds() > seconds)
      {
        return result;
      }
      length *= trial == 0 ? 1.0 : 0.5;
      next = weights + (length * step).cast<DoubleDouble>();
      accepted = diagram.update(next) && diagram.areas().minCoeff() >= least &&
                 (targets - diagram.areas()).norm() <= (1.0 - 0.5 * length) * gap.norm();
    }
    if (!accepted)
    {
      return result;
    }
    weights = next;
    ++result.Steps;
    result.CellError = cellError(diagram.areas(), targets);
  }
  result.Converged = true;
  return result;
}

} // namespace flattening::benchmarks
