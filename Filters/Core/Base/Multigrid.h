// SPDX-License-Identifier: GPL-3.0-or-later
/// An algebraic multigrid method for large linear systems, whose time and memory grow as their size.
#pragma once

#include "Base/Progress.h"
#include "Base/RowMatrix.h"
#include "Base/SparseFactorization.h"

#include <vector>

namespace flattening
{

/// A V-cycle of smoothed aggregation (Vanek, Mandel and Brezina 1996, "Algebraic multigrid by smoothed
/// aggregation for second and fourth order elliptic problems") as preconditioner for the Laplacian of a
/// graph that is fixed at some vertices. It is symmetric and positive definite, and its bits do not
/// depend on the number of threads.
class Multigrid
{
public:
  /// Builds the levels for a symmetric matrix. Returns false if it is not positive definite as far as
  /// they can tell. @throws Cancelled; only destruction is allowed then
  bool compute(RowMatrix matrix, const ProgressCallback& progress);

  /// Number of unknowns.
  int rows() const { return this->Levels.empty() ? 0 : this->Levels.front().Matrix.rows(); }

  /// The right sides of @p K systems (1 or 2), row by row: to be set before each cycle.
  template <int K>
  std::vector<float>& rightSides();
  /// Approximates the solutions for the right sides, linearly in these.
  template <int K>
  const std::vector<float>& cycle();

private:
  // The unknowns of each level but the first stand for groups of unknowns of the level before.
  struct Level
  {
    RowMatrix Matrix;
    std::vector<float> Diagonal;
    float GreatestEigenvalue = 0.0F; // at least that of the matrix with its diagonal scaled to 1
    RowMatrix Prolongation;          // from the next level
    RowMatrix Restriction;           // its transpose
    // Row by row, in a cycle:
    std::vector<float> RightSide;
    std::vector<float> Solution;
    std::vector<float> Step; // the last one of the smoother
    std::vector<float> Next; // solution of the smoother
  };

  template <int K>
  void cycleFrom(std::size_t number);
  template <int K>
  void solveCoarsest(std::vector<float>& values) const;
  template <int K>
  static void smooth(Level& level, bool fromZero);

  std::vector<Level> Levels; // fine to coarse, without the coarsest
  SparseCholesky Coarsest{ SparseCholesky::Ordering::Quick };
};

} // namespace flattening
