// SPDX-License-Identifier: GPL-3.0-or-later
/// What Eigen 3.4 and Eigen 5 have in different places. All guards for Eigen's versions are here.
#pragma once

#include <Eigen/Core>

namespace flattening
{

/// Every row, or every column, of a matrix that is indexed by a list: matrix(rows, flattening::all).
#if EIGEN_MAJOR_VERSION >= 5
using Eigen::placeholders::all;
#else
using Eigen::all;
#endif

} // namespace flattening
