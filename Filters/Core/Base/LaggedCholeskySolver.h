// SPDX-License-Identifier: GPL-3.0-or-later
/// Solves a sequence of similar positive definite systems with few factorizations.
#pragma once

#include "Base/Progress.h"
#include "Base/SparseFactorization.h"

namespace flattening
{

/// Conjugate gradients with the Cholesky factor of an earlier matrix of the sequence as preconditioner:
/// a solution with a known factor costs a twentieth of a new factor. A new factor is computed when too
/// many iterations are needed.
class LaggedCholeskySolver
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
  /// Makes the next call of solve() factor its matrix.
  void forgetFactor() { this->Size = -1; }
  bool hasFactor() const { return this->Size >= 0; }

  /// The order of elimination of the last factor; empty without one.
  const EliminationOrder& order() const { return this->Factor.order(); }

  int factorizations() const { return this->Factorizations; }
  int iterations() const { return this->Iterations; }

private:
  bool factor(const SparseMatrix& lower, const ProgressCallback& progress);
  bool iterate(const SparseMatrix& lower,
    const Eigen::VectorXd& rightSide,
    double tolerance,
    Eigen::VectorXd& solution,
    const ProgressCallback& progress);

  SparseCholesky Factor{ SparseCholesky::Ordering::Quick };
  Eigen::Index Size = -1;    // number of rows of the factor; -1 without one
  double LogReduction = 0.0; // logarithm of the ratio by which an iteration reduced the last residual
  int Factorizations = 0;
  int Iterations = 0;
};

} // namespace flattening
