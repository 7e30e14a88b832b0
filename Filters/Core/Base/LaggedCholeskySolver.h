// SPDX-License-Identifier: GPL-3.0-or-later
/// Solves a sequence of similar positive definite systems with few factorizations.
#pragma once

#include "Base/Progress.h"
#include "Base/SparseFactorization.h"

#include <future>

namespace flattening
{

/// Conjugate gradients with the Cholesky factor of an earlier matrix of the sequence as preconditioner:
/// a solution with a known factor costs a twentieth of a new factor. A new one is made when the
/// iterations become too many.
class LaggedCholeskySolver
{
public:
  /// Solves A x = b up to a residual of @p tolerance times b, in the Euclidean norm. @p lower is the
  /// lower half of A. False if a new factor was needed and A is not positive definite.
  /// @throws Cancelled  not to be used again afterwards
  bool solve(const SparseMatrix& lower,
    const Eigen::VectorXd& rightSide,
    double tolerance,
    Eigen::VectorXd& solution,
    const ProgressCallback& progress = {});

  /// How many iterations would reduce a residual so much, judged by the last system; 0 right after a
  /// factorization.
  double iterationsFor(double reduction) const;
  /// The next system's matrix will be factored.
  void forgetFactor() { this->Size = -1; }
  bool hasFactor() const { return this->Size >= 0; }

  /// Begins to look for an order of elimination for matrices of the pattern of @p lower, in another
  /// thread while systems are solved with the factor at hand: the next factor is made in it.
  void renewOrder(const SparseMatrix& lower);
  /// The last that was found, for the last factor or by renewOrder().
  const EliminationOrder& order();

  int factorizations() const { return this->Factorizations; }
  int iterations() const { return this->Iterations; }

private:
  bool factor(const SparseMatrix& lower, const ProgressCallback& progress);
  bool iterate(const SparseMatrix& lower,
    const Eigen::VectorXd& rightSide,
    double tolerance,
    Eigen::VectorXd& solution,
    const ProgressCallback& progress);

  void takeNewOrder();

  std::future<EliminationOrder> NewOrder;
  SparseCholesky Factor{ SparseCholesky::Ordering::Quick };
  Eigen::Index Size = -1;    // of the factor; -1 without one
  double LogReduction = 0.0; // of the residual by one iteration for the last system
  int Factorizations = 0;
  int Iterations = 0;
};

} // namespace flattening
