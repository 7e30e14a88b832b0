// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/SparseFactorization.h"

namespace flattening
{
namespace
{

// An order that makes the factor so many times as large as it was is given up.
constexpr double GreatestGrowth = 1.15;

} // namespace

std::unique_ptr<BlasLock> SparseCholesky::turn() const
{
  return this->UsesBlas ? std::make_unique<BlasLock>() : nullptr;
}

// Analyses the pattern in the order that is known. False if that order does not serve.
bool SparseCholesky::reuseOrder(const SparseMatrix& matrix)
{
  if (static_cast<Eigen::Index>(this->Order.Unknowns.size()) != matrix.rows())
  {
    return false;
  }
  cholmod_common& common = this->cholmod();
  cholmod_sparse view = Eigen::viewAsCholmod(matrix.selfadjointView<Eigen::Lower>());
  const int methods = common.nmethods;
  common.nmethods = 1; // of which the first is the given order
  cholmod_factor* factor = cholmod_analyze_p(&view, this->Order.Unknowns.data(), nullptr, 0, &common);
  common.nmethods = methods;
  if (!factor || common.lnz > GreatestGrowth * this->Order.Fill)
  {
    cholmod_free_factor(&factor, &common);
    return false;
  }
  cholmod_free_factor(&this->m_cholmodFactor, &common);
  this->m_cholmodFactor = factor;
  this->m_isInitialized = true;
  this->m_info = Eigen::Success;
  this->m_analysisIsOk = true;
  this->m_factorizationIsOk = false;
  return true;
}

void SparseCholesky::findOrder(const SparseMatrix& matrix)
{
  cholmod_common& common = this->cholmod();
  const int methods = common.nmethods;
  const int first = common.method[0].ordering;
  if (this->Search == Ordering::Quick)
  {
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
  }
  this->analyzePattern(matrix);
  common.nmethods = methods;
  common.method[0].ordering = first;
  const auto* order = static_cast<const int*>(this->m_cholmodFactor->Perm);
  this->Order.Unknowns.assign(order, order + matrix.rows());
  this->Order.Fill = common.lnz;
}

EliminationOrder SparseCholesky::orderOf(const SparseMatrix& pattern, Ordering ordering)
{
  SparseCholesky cholesky(ordering);
  cholesky.findOrder(pattern);
  return cholesky.order();
}

SparseCholesky& SparseCholesky::recompute(const SparseMatrix& matrix)
{
  const std::unique_ptr<BlasLock> lock = this->turn();
  this->factorize(matrix);
  return *this;
}

SparseCholesky& SparseCholesky::compute(const SparseMatrix& matrix)
{
  if (!this->reuseOrder(matrix))
  {
    this->findOrder(matrix);
  }
  const std::unique_ptr<BlasLock> lock = this->turn();
  this->factorize(matrix);
  return *this;
}

} // namespace flattening
