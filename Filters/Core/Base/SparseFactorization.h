// SPDX-License-Identifier: GPL-3.0-or-later
/// The sparse factorization that all of Core uses.
#pragma once

#include "Base/BlasLock.h"

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>

#include <memory>
#include <utility>
#include <vector>

namespace flattening
{

using SparseMatrix = Eigen::SparseMatrix<double>;

/// In which order the unknowns of a matrix are eliminated, and what came of it.
struct EliminationOrder
{
  std::vector<int> Unknowns;
  double Fill = 0.0; ///< entries of the factor
};

/// CHOLMOD's. A matrix of the same size as the one before is taken for the next of a sequence whose
/// patterns change little, as Newton's method makes them: the order of elimination, which takes about as
/// long to find as the factors do, is kept as long as it serves. May be used in several threads at once,
/// which wait for each other (BlasLock).
/// Kernel::Entries does without BLAS and without waiting.
class SparseCholesky : public Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower>
{
public:
  /// How hard to look for an order of elimination. The thorough search (METIS) of a large matrix takes
  /// as long as three factorizations and saves a third of each.
  enum class Ordering
  {
    Quick,
    Thorough
  };

  /// Blocks of columns, or entry by entry, which is as fast for some thousands of unknowns.
  enum class Kernel
  {
    Blocks,
    Entries
  };

  explicit SparseCholesky(Ordering ordering = Ordering::Thorough)
    : Search(ordering)
  {
  }
  /// For one factorization.
  explicit SparseCholesky(const SparseMatrix& matrix)
    : Search(Ordering::Quick)
  {
    this->compute(matrix);
  }
  ~SparseCholesky() = default;

  /// An order to begin with, that of a matrix of nearly the same pattern. Rows and fill are this
  /// matrix's.
  explicit SparseCholesky(EliminationOrder order, Kernel kernel = Kernel::Blocks)
    : Search(Ordering::Quick)
    , Order(std::move(order))
    , UsesBlas(kernel == Kernel::Blocks)
  {
    if (kernel == Kernel::Entries)
    {
      this->cholmod().final_asis = 0;
      this->cholmod().final_ll = 1;
      this->cholmod().supernodal = CHOLMOD_SIMPLICIAL;
      this->cholmod().print = 0;
    }
  }

  SparseCholesky& compute(const SparseMatrix& matrix);

  /// The same for a matrix of exactly the pattern of the one before.
  SparseCholesky& recompute(const SparseMatrix& matrix);

  /// An order for matrices of the pattern of @p pattern (lower triangle).
  static EliminationOrder orderOf(const SparseMatrix& pattern, Ordering ordering);

  /// Of the last matrix.
  const EliminationOrder& order() const { return this->Order; }
  /// The order to try for the next matrix.
  void setOrder(EliminationOrder order) { this->Order = std::move(order); }

  template <typename Derived>
  typename Derived::PlainObject solve(const Eigen::MatrixBase<Derived>& rightSide) const
  {
    const std::unique_ptr<BlasLock> lock = this->turn();
    return Base::solve(rightSide);
  }

private:
  using Base = Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower>;
  bool reuseOrder(const SparseMatrix& matrix);
  void findOrder(const SparseMatrix& matrix);

  std::unique_ptr<BlasLock> turn() const; // to use BLAS, if this does

  Ordering Search;
  EliminationOrder Order; // with the fill of the matrix that it was found for
  bool UsesBlas = true;
};

} // namespace flattening
