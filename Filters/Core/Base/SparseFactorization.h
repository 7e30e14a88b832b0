// SPDX-License-Identifier: GPL-3.0-or-later
/// Direct solvers for sparse linear systems. They may be used in several threads at once, which wait for
/// each other where a solver calls BLAS, and an abort does not wait until a long factorization has
/// ended.
#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace flattening
{

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The order in which the unknowns of a matrix are eliminated.
struct EliminationOrder
{
  std::vector<int> Unknowns;
  double Fill = 0.0; ///< number of entries of the factor
};

/// The Cholesky factorization of CHOLMOD. A matrix of the same size as the one before is taken for the
/// next of a sequence whose patterns change little, as those of Newton's method do: the order of
/// elimination, which takes about as long to find as the factor, is kept as long as it serves.
class SparseCholesky
{
public:
  /// How hard to look for an order of elimination. The thorough search (METIS) of a large matrix takes
  /// as long as three factorizations and saves a third of each.
  enum class Ordering
  {
    Quick,
    Thorough
  };

  /// A factor is computed by blocks of columns (with BLAS), or entry by entry, which is as fast for some
  /// thousands of unknowns and never waits for another thread.
  enum class Kernel
  {
    Blocks,
    Entries
  };

  explicit SparseCholesky(Ordering ordering = Ordering::Thorough);
  /// Begins with the order of a matrix of nearly the same pattern. Where it does not serve, a quick
  /// search finds another one.
  explicit SparseCholesky(EliminationOrder order, Kernel kernel = Kernel::Blocks);
  /// Factors @p matrix in an order from a quick search.
  explicit SparseCholesky(const SparseMatrix& matrix);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// Factors the symmetric matrix whose lower triangle is that of @p matrix; info() tells the result.
  void compute(const SparseMatrix& matrix);
  /// Does the same in another thread and reports @p fraction and @p stage meanwhile (callInterruptibly).
  /// @throws Cancelled as soon as @p progress returns false; only destruction is allowed then
  void compute(SparseMatrix matrix,
    const ProgressCallback& progress,
    double fraction,
    const char* stage);

  /// Promises that all matrices have the pattern of the first one, so that only that one is analysed.
  void expectConstantPattern();

  /// Success if the last matrix was positive definite.
  Eigen::ComputationInfo info() const;

  /// The solution for every column of @p rightSide.
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& rightSide) const;

  /// The rows and the columns @p unknowns of the inverse matrix, which take much less time than its
  /// whole columns. Only for factors that are computed entry by entry.
  Eigen::MatrixXd inverseAt(const std::vector<int>& unknowns) const;

  /// The order of the last matrix, with the fill of the matrix that it was found for.
  const EliminationOrder& order() const;

  /// An order for matrices of the pattern of @p pattern (lower triangle). It is found in another thread,
  /// with reports meanwhile. @throws Cancelled.
  static EliminationOrder orderOf(SparseMatrix pattern,
    Ordering ordering,
    const ProgressCallback& progress,
    double fraction,
    const char* stage);

private:
  struct Factor;
  std::shared_ptr<Factor> Shared; // with the thread that computes it and may outlive this object
};

/// The LU factorization of UMFPACK for matrices that are not symmetric. Solutions are not refined.
class SparseLu
{
public:
  explicit SparseLu(SparseMatrix matrix);
  /// Factors in another thread and reports @p fraction and @p stage meanwhile (callInterruptibly).
  /// @throws Cancelled.
  SparseLu(SparseMatrix matrix, const ProgressCallback& progress, double fraction, const char* stage);
  ~SparseLu();
  SparseLu(const SparseLu&) = delete;
  SparseLu& operator=(const SparseLu&) = delete;

  /// Success if the matrix is not singular.
  Eigen::ComputationInfo info() const;

  /// The solution for every column of @p rightSide.
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& rightSide) const;
  /// The same for the transposed matrix.
  Eigen::MatrixXd solveTransposed(const Eigen::Ref<const Eigen::MatrixXd>& rightSide) const;

private:
  struct Factors;
  std::shared_ptr<Factors> Shared; // with the thread that computes them and may outlive this object
};

} // namespace flattening
