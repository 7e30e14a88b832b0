// SPDX-License-Identifier: GPL-3.0-or-later
/// The sparse factorization of matrices that are not symmetric.
#pragma once

#include "Base/BlasLock.h"
#include "Base/SparseFactorization.h"

#include <Eigen/UmfPackSupport>

namespace flattening
{

/// UMFPACK's, without its refinement of solutions. May be used in several threads at
/// once, which wait for each other as those of SparseCholesky do. The matrix must outlive it.
class SparseLu : public Eigen::UmfPackLU<SparseMatrix>
{
public:
  explicit SparseLu(const SparseMatrix& matrix);

  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightSide) const;
  /// The solution of the transposed matrix.
  Eigen::VectorXd solveTransposed(const Eigen::VectorXd& rightSide) const;

private:
  Eigen::VectorXd solve(int system, const Eigen::VectorXd& rightSide) const;
};

} // namespace flattening
