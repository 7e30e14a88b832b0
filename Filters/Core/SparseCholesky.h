// SPDX-License-Identifier: GPL-3.0-or-later
/// The sparse factorization that all of Core uses.
#pragma once

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>

namespace flattening
{

using SparseMatrix = Eigen::SparseMatrix<double>;
using SparseCholesky = Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower>;

} // namespace flattening
