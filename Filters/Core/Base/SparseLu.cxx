// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/SparseLu.h"

namespace flattening
{

SparseLu::SparseLu(const SparseMatrix& matrix)
{
  const BlasLock lock;
  this->compute(matrix);
}

Eigen::VectorXd SparseLu::solve(int system, const Eigen::VectorXd& rightSide) const
{
  Eigen::VectorXd solution(rightSide.size());
  const BlasLock lock;
  double control[UMFPACK_CONTROL];
  double info[UMFPACK_INFO];
  umfpack_di_defaults(control);
  control[UMFPACK_IRSTEP] = 0; // who needs it refines by residuals of his own
  umfpack_di_solve(system,
    this->mp_matrix.outerIndexPtr(),
    this->mp_matrix.innerIndexPtr(),
    this->mp_matrix.valuePtr(),
    solution.data(),
    rightSide.data(),
    this->m_numeric,
    control,
    info);
  return solution;
}

Eigen::MatrixXd SparseLu::solve(const Eigen::MatrixXd& rightSide) const
{
  Eigen::MatrixXd solution(rightSide.rows(), rightSide.cols());
  for (Eigen::Index k = 0; k < rightSide.cols(); ++k)
  {
    solution.col(k) = this->solve(UMFPACK_A, rightSide.col(k));
  }
  return solution;
}

Eigen::VectorXd SparseLu::solveTransposed(const Eigen::VectorXd& rightSide) const
{
  return this->solve(UMFPACK_At, rightSide);
}

} // namespace flattening
