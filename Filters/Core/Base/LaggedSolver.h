// SPDX-License-Identifier: GPL-3.0-or-later
/// Solves a sequence of similar positive definite systems, such as those of Newton's method.
#pragma once

#include "Base/MultigridSolver.h"
#include "Base/Progress.h"
#include "Base/SparseFactorization.h"

namespace flattening
{

/// Conjugate gradients with a preconditioner that was computed for an earlier matrix of the sequence, as
/// long as it serves. Small systems have a Cholesky factor as preconditioner, with which a solution
/// costs a twentieth of a new factor. Large ones are expected to be Laplacians of graphs and have a
/// multigrid cycle; where that fails, they are treated as small ones.
class LaggedSolver
{
public:
  /// Solves A x = b up to a residual of @p tolerance times b, in the Euclidean norm. @p lower is the
  /// lower triangle of A. Returns false if a new factor was needed and A is not positive definite.
  /// @throws Cancelled; only destruction is allowed then
  bool solve(const SparseMatrix& lower,
    const Eigen::VectorXd& rightSide,
    double tolerance,
    Eigen::VectorXd& solution,
    const ProgressCallback& progress = {});

  /// The predicted number of iterations that multiply a residual by @p reduction (0 to 1), judged by the
  /// last system; 0 right after a factorization.
  double iterationsFor(double reduction) const;
  /// Makes the next call of solve() compute a new preconditioner.
  void forgetPreconditioner();
  bool hasPreconditioner() const { return this->Size >= 0; }

  /// The order of elimination of the last factor; empty without one.
  const EliminationOrder& order() const { return this->Factor.order(); }

  int factorizations() const { return this->Factorizations; }
  int iterations() const { return this->Iterations; }

private:
  bool factor(const SparseMatrix& lower, const ProgressCallback& progress);
  bool solveWithLevels(const SparseMatrix& lower,
    const Eigen::VectorXd& rightSide,
    double tolerance,
    Eigen::VectorXd& solution,
    const ProgressCallback& progress);
  bool iterate(const SparseMatrix& lower,
    const Eigen::VectorXd& rightSide,
    double tolerance,
    Eigen::VectorXd& solution,
    const ProgressCallback& progress);

  SparseCholesky Factor{ SparseCholesky::Ordering::Quick };
  MultigridSolver Levels;
  // Whether levels of an earlier matrix took so many more iterations that new ones would have been
  // faster.
  bool LevelsAgeFast = false;
  bool LevelsServe = true;   // until they fail with a matrix of their own
  Eigen::Index Size = -1;    // number of rows of the preconditioner; -1 without one
  double LogReduction = 0.0; // logarithm of the ratio by which an iteration reduced the last residual
  int Factorizations = 0;
  int Iterations = 0;
};

} // namespace flattening
