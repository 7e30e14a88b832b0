// SPDX-License-Identifier: GPL-3.0-or-later
/// Solves large linear systems by conjugate gradients and a multigrid method.
#pragma once

#include "Base/Multigrid.h"
#include "Base/Progress.h"
#include "Base/SparseFactorization.h"

namespace flattening
{

/// Conjugate gradients with a cycle of Multigrid as preconditioner. The bits of a solution do not depend
/// on the number of threads.
class MultigridSolver
{
public:
  /// The number of unknowns from which on a system is large enough. On brains of 35 and 66 thousand
  /// vertices, factors take as long on two cores; with 131 thousand, the systems of a Ricci flow take
  /// 0.3 instead of 0.7 seconds, with a million 2.5 instead of 9.5, and two thirds of the memory.
  static constexpr int LeastUnknowns = 100000;

  /// Takes the symmetric matrix whose lower triangle is that of @p lower, and keeps the levels that were
  /// computed for an earlier one.
  void setMatrix(const SparseMatrix& lower);
  /// Computes the levels for the matrix. Returns false if it is not positive definite as far as they can
  /// tell. @throws Cancelled; only destruction is allowed then
  bool computeLevels(const ProgressCallback& progress = {});

  /// Solves the system with levels of the same size for one or two right sides, up to a residual of @p
  /// tolerance times the right side each, in the Euclidean norm. Returns false if the matrix is not
  /// positive definite, or after many iterations. @throws Cancelled; only destruction is allowed then
  bool solve(const Eigen::Ref<const Eigen::MatrixXd>& rightSides,
    double tolerance,
    Eigen::MatrixXd& solutions,
    const ProgressCallback& progress = {});

  int iterations() const { return this->Iterations; }

private:
  template <int K>
  bool iterate(const Eigen::Ref<const Eigen::MatrixXd>& rightSides,
    double tolerance,
    Eigen::MatrixXd& solutions,
    const ProgressCallback& progress);

  Eigen::SparseMatrix<double, Eigen::RowMajor> Matrix;
  Multigrid Levels;
  int Iterations = 0;
};

} // namespace flattening
