// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/LaggedSolver.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{

// A factorization takes about as long as twenty solutions with the factor, so that more iterations are
// not begun if the last system predicts them. Iterations that were begun may be some more, because most
// of them are done then. Both constants change times only.
constexpr int ManyIterations = 20;
constexpr int MostIterations = 30;

// New levels take as long as this number of iterations with them.
constexpr int WorthLevels = 10;

constexpr const char* FactorStage = "Factorization";
constexpr const char* SolutionStage = "Solution";

} // namespace

bool LaggedSolver::factor(const SparseMatrix& lower, const ProgressCallback& progress)
{
  this->Factor.compute(lower, progress, 0.0, FactorStage);
  ++this->Factorizations;
  this->LogReduction = -HUGE_VAL;
  this->Size = this->Factor.info() == Eigen::Success ? lower.rows() : -1;
  return this->Size >= 0;
}

// Tries the levels of an earlier matrix, unless they are known to age fast, and then new ones.
bool LaggedSolver::solveWithLevels(const SparseMatrix& lower,
  const Eigen::VectorXd& rightSide,
  double tolerance,
  Eigen::VectorXd& solution,
  const ProgressCallback& progress)
{
  this->Levels.setMatrix(lower);
  bool isNew = false;
  while (!isNew)
  {
    isNew = this->Size != lower.rows() || this->LevelsAgeFast;
    if (isNew && !this->Levels.computeLevels(progress))
    {
      break;
    }
    const double expected = this->Size == lower.rows() ? this->iterationsFor(tolerance) : 0.0;
    this->Size = -1;
    Eigen::MatrixXd found;
    const int before = this->Levels.iterations();
    const bool isSolved = this->Levels.solve(rightSide, tolerance, found, progress);
    const int iterations = this->Levels.iterations() - before;
    this->Iterations += iterations;
    this->LevelsAgeFast = this->LevelsAgeFast || (!isNew && iterations > expected + WorthLevels);
    if (isSolved)
    {
      this->Size = lower.rows();
      this->LogReduction = std::log(tolerance) / std::max(iterations, 1);
      solution = found;
      return true;
    }
  }
  this->LevelsServe = false;
  return false;
}

bool LaggedSolver::iterate(const SparseMatrix& lower,
  const Eigen::VectorXd& rightSide,
  double tolerance,
  Eigen::VectorXd& solution,
  const ProgressCallback& progress)
{
  solution.setZero(rightSide.size());
  Eigen::VectorXd residual = rightSide;
  Eigen::VectorXd direction;
  const double enough = tolerance * rightSide.norm();
  double previous = 0.0;
  for (int k = 0; k < MostIterations; ++k)
  {
    report(progress, 0.0, SolutionStage);
    const Eigen::VectorXd preconditioned = this->Factor.solve(residual);
    const double descent = residual.dot(preconditioned);
    direction = k == 0 ? preconditioned : (preconditioned + descent / previous * direction).eval();
    previous = descent;
    const Eigen::VectorXd product = lower.selfadjointView<Eigen::Lower>() * direction;
    const double length = descent / direction.dot(product);
    if (!(length > 0.0))
    {
      break;
    }
    solution += length * direction;
    residual -= length * product;
    ++this->Iterations;
    if (residual.norm() <= enough)
    {
      this->LogReduction = std::log(residual.norm() / rightSide.norm()) / (k + 1);
      return true;
    }
  }
  return false;
}

void LaggedSolver::forgetPreconditioner()
{
  this->Size = -1;
  this->LevelsAgeFast = false;
}

double LaggedSolver::iterationsFor(double reduction) const
{
  return std::log(reduction) / this->LogReduction;
}

bool LaggedSolver::solve(const SparseMatrix& lower,
  const Eigen::VectorXd& rightSide,
  double tolerance,
  Eigen::VectorXd& solution,
  const ProgressCallback& progress)
{
  if (this->LevelsServe && lower.rows() >= MultigridSolver::LeastUnknowns &&
      this->solveWithLevels(lower, rightSide, tolerance, solution, progress))
  {
    return true;
  }
  if (this->Size == lower.rows() && this->iterationsFor(tolerance) <= ManyIterations &&
      this->iterate(lower, rightSide, tolerance, solution, progress))
  {
    return true;
  }
  if (!this->factor(lower, progress))
  {
    return false;
  }
  solution = this->Factor.solve(rightSide);
  return rightSide.dot(solution) >= 0.0; // small indefinite matrices are factored all the same
}

} // namespace flattening
