// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/GraphLaplacian.h"

#include "Base/Errors.h"

#include <algorithm>
#include <utility>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
// Rounds of correction by the residual after the first solution. A round costs one solution, little
// beside the factor; without any, vertices that lie much closer together than others lose the digits of
// their distances.
constexpr int Refinements = 2;
// Large symmetric systems are solved with multigrid cycles if their diagonal entries lie within this
// ratio. Those of cotangents lay within 400 on three scans, those of the weights by which protrusions
// are spread not within 1e40; for these, cycles do not converge.
constexpr double MostRange = 1e6;
// Share of the residual that such a solution may leave, where rounds of correction follow and where not.
constexpr double CorrectedTolerance = 1e-6;
constexpr double FinalTolerance = 1e-12;
constexpr const char* LayoutStage = "Layout";

} // namespace

WeightedMeans::WeightedMeans(std::vector<NeighbourWeight> weights,
  WeightSymmetry symmetry,
  const std::vector<char>& fixed,
  const ProgressCallback& progress,
  const EliminationOrder& order)
  : Row(fixed.size(), -1)
  , Weights(std::move(weights))
{
  report(progress, 0.0, LayoutStage);
  for (std::size_t v = 0; v < fixed.size(); ++v)
  {
    if (!fixed[v])
    {
      this->Row[v] = static_cast<int>(this->Free.size());
      this->Free.push_back(static_cast<int>(v));
    }
  }
  const auto isUnused = [this](const NeighbourWeight& w)
  { return this->Row[w.From] < 0 || !(w.Weight > 0.0); };
  this->Weights.erase(
    std::remove_if(this->Weights.begin(), this->Weights.end(), isUnused), this->Weights.end());
  if (this->Free.empty())
  {
    return;
  }
  SparseMatrix matrix = this->matrix(symmetry);
  const bool isLarge =
    symmetry == WeightSymmetry::Symmetric && matrix.rows() >= MultigridSolver::LeastUnknowns;
  if (!isLarge || !this->computeLevels(matrix, progress))
  {
    this->factor(std::move(matrix), symmetry, order, progress);
  }
}

// The rows of the free vertices, in the order of the vertices.
EliminationOrder WeightedMeans::orderOfFree(const EliminationOrder& order) const
{
  EliminationOrder free;
  free.Fill = order.Fill;
  for (const int v : order.Unknowns)
  {
    if (this->Row[v] >= 0)
    {
      free.Unknowns.push_back(this->Row[v]);
    }
  }
  return free;
}

// The matrix of the equations; if it is symmetric, its lower triangle alone.
SparseMatrix WeightedMeans::matrix(WeightSymmetry symmetry) const
{
  const auto size = static_cast<Eigen::Index>(this->Free.size());
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(size);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(this->Free.size() + this->Weights.size());
  for (const NeighbourWeight& w : this->Weights)
  {
    const int i = this->Row[w.From];
    const int j = this->Row[w.To];
    diagonal[i] += w.Weight;
    if (j >= 0 && (symmetry == WeightSymmetry::General || j < i))
    {
      entries.emplace_back(i, j, -w.Weight);
    }
  }
  for (Eigen::Index i = 0; i < size; ++i)
  {
    entries.emplace_back(i, i, diagonal[i]);
  }
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

bool WeightedMeans::computeLevels(const SparseMatrix& matrix, const ProgressCallback& progress)
{
  const Eigen::VectorXd diagonal = matrix.diagonal();
  if (!(diagonal.maxCoeff() <= MostRange * diagonal.minCoeff()))
  {
    return false;
  }
  this->Levels = std::make_unique<MultigridSolver>();
  this->Levels->setMatrix(matrix);
  if (!this->Levels->computeLevels(atFraction(progress, 0.2, LayoutStage)))
  {
    this->Levels.reset();
  }
  return this->Levels != nullptr;
}

void WeightedMeans::factor(SparseMatrix matrix,
  WeightSymmetry symmetry,
  const EliminationOrder& order,
  const ProgressCallback& progress)
{
  if (symmetry == WeightSymmetry::Symmetric)
  {
    this->Cholesky.emplace(this->orderOfFree(order));
    this->Cholesky->compute(std::move(matrix), progress, 0.2, LayoutStage);
  }
  else
  {
    this->Lu.emplace(std::move(matrix), progress, 0.2, LayoutStage);
  }
  report(progress, 0.8, LayoutStage);
  if ((this->Cholesky ? this->Cholesky->info() : this->Lu->info()) != Eigen::Success)
  {
    throw ConvergenceError("the weights of neighbours could not be factored: remesh the surface "
                           "(Surface To Disk, Remesh)");
  }
}

Eigen::MatrixXd WeightedMeans::solution(const Eigen::MatrixXd& rightSides,
  double tolerance,
  const ProgressCallback& progress)
{
  const ProgressCallback here = atFraction(progress, 0.8, LayoutStage);
  if (this->Levels)
  {
    Eigen::MatrixXd solutions;
    if (this->Levels->solve(rightSides, tolerance, solutions, here))
    {
      return solutions;
    }
    this->Levels.reset();
    this->factor(this->matrix(WeightSymmetry::Symmetric), WeightSymmetry::Symmetric, {}, here);
  }
  return this->Cholesky ? this->Cholesky->solve(rightSides) : this->Lu->solve(rightSides);
}

void WeightedMeans::extend(ComplexVector& positions, const ProgressCallback& progress)
{
  // Residuals are sums of differences, which keep their digits where neighbours are close.
  for (int round = 0; !this->Free.empty() && round < 1 + Refinements; ++round)
  {
    Eigen::MatrixXd residual = Eigen::MatrixXd::Zero(this->Free.size(), 2);
    for (const NeighbourWeight& w : this->Weights)
    {
      const Complex pull = w.Weight * (positions[w.To] - positions[w.From]);
      residual.row(this->Row[w.From]) += Eigen::RowVector2d(pull.real(), pull.imag());
    }
    const Eigen::MatrixXd change = this->solution(residual, CorrectedTolerance, progress);
    for (std::size_t i = 0; i < this->Free.size(); ++i)
    {
      positions[this->Free[i]] += Complex(change(i, 0), change(i, 1));
    }
  }
}

Eigen::VectorXd WeightedMeans::potential(const Eigen::VectorXd& vertexWeights,
  const ProgressCallback& progress)
{
  Eigen::VectorXd potential = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(this->Row.size()));
  if (!this->Free.empty())
  {
    potential(this->Free) = this->solution(vertexWeights(this->Free), FinalTolerance, progress);
  }
  return potential;
}

Eigen::VectorXd WeightedMeans::passedToFixed(const Eigen::VectorXd& vertexWeights,
  const ProgressCallback& progress)
{
  Eigen::VectorXd all = vertexWeights;
  if (!this->Free.empty())
  {
    const Eigen::VectorXd free = vertexWeights(this->Free);
    const Eigen::VectorXd passed =
      this->Lu ? this->Lu->solveTransposed(free) : this->solution(free, FinalTolerance, progress);
    for (const NeighbourWeight& w : this->Weights)
    {
      all[w.To] += this->Row[w.To] < 0 ? w.Weight * passed[this->Row[w.From]] : 0.0;
    }
  }
  return all;
}

} // namespace flattening
