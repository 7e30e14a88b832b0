// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/MultigridSolver.h"

#include <cmath>
#include <vector>

namespace flattening
{
namespace
{

using FullMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
template <int K>
using DoubleRow = Eigen::Array<double, K, 1>;
template <int K>
using Columns = Eigen::Array<double, K, Eigen::Dynamic>; // in memory, row by row

// A guard: systems of brains take 20 at most for a reduction by a million. Those that take more have
// weights over many decades, for which a factor is better.
constexpr int MostCycles = 60;
constexpr const char* CyclesStage = "Solution of a linear system";

RowMatrix inSinglePrecision(const FullMatrix& matrix)
{
  RowMatrix a;
  a.Columns = static_cast<int>(matrix.cols());
  a.Begin.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.rows() + 1);
  a.Column.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
  a.Value.assign(matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros());
  return a;
}

// The sum of term(i) over all rows, whose bits do not depend on the number of threads.
template <int K, class F>
DoubleRow<K> sumOverRows(int count, const F& term)
{
  std::vector<DoubleRow<K>> parts(count / RowsPerPart + 1, DoubleRow<K>::Zero());
  forRows(count,
    [&](int begin, int end)
    {
      DoubleRow<K> sum = DoubleRow<K>::Zero();
      for (int i = begin; i < end; ++i)
      {
        sum += term(i);
      }
      parts[begin / RowsPerPart] = sum;
    });
  DoubleRow<K> all = DoubleRow<K>::Zero();
  for (const DoubleRow<K>& part : parts)
  {
    all += part;
  }
  return all;
}

template <int K>
DoubleRow<K> rowTimes(const FullMatrix& matrix, int i, const Columns<K>& x)
{
  DoubleRow<K> sum = DoubleRow<K>::Zero();
  for (FullMatrix::InnerIterator e(matrix, i); e; ++e)
  {
    sum += e.value() * x.col(e.col());
  }
  return sum;
}

// An approximate solution for the residuals, each of which is scaled by its norm into the range of
// single precision.
template <int K>
class Preconditioner
{
public:
  explicit Preconditioner(Multigrid& levels)
    : Levels(levels)
  {
  }

  void compute(const Columns<K>& residuals, const DoubleRow<K>& norms)
  {
    this->Norms = norms;
    const DoubleRow<K> scales = (norms > 0.0).select(norms.inverse(), 0.0);
    std::vector<float>& scaled = this->Levels.template rightSides<K>();
    forRows(static_cast<int>(residuals.cols()),
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          Eigen::Map<Eigen::Array<float, K, 1>>(scaled.data() + static_cast<std::size_t>(i) * K) =
            (scales * residuals.col(i)).template cast<float>();
        }
      });
    this->Solutions = &this->Levels.template cycle<K>();
  }

  DoubleRow<K> row(int i) const
  {
    return this->Norms * Eigen::Map<const Eigen::Array<float, K, 1>>(
                           this->Solutions->data() + static_cast<std::size_t>(i) * K)
                           .template cast<double>();
  }

private:
  Multigrid& Levels;
  DoubleRow<K> Norms;
  const std::vector<float>* Solutions = nullptr;
};

} // namespace

void MultigridSolver::setMatrix(const SparseMatrix& lower)
{
  this->Matrix = lower.selfadjointView<Eigen::Lower>();
}

bool MultigridSolver::computeLevels(const ProgressCallback& progress)
{
  return this->Levels.compute(inSinglePrecision(this->Matrix), progress);
}

bool MultigridSolver::solve(const Eigen::Ref<const Eigen::MatrixXd>& rightSides,
  double tolerance,
  Eigen::MatrixXd& solutions,
  const ProgressCallback& progress)
{
  return rightSides.cols() == 1 ? this->iterate<1>(rightSides, tolerance, solutions, progress)
                                : this->iterate<2>(rightSides, tolerance, solutions, progress);
}

template <int K>
bool MultigridSolver::iterate(const Eigen::Ref<const Eigen::MatrixXd>& rightSides,
  double tolerance,
  Eigen::MatrixXd& solutions,
  const ProgressCallback& progress)
{
  const int n = static_cast<int>(this->Matrix.rows());
  Columns<K> residuals = rightSides.transpose().array();
  Columns<K> found = Columns<K>::Zero(K, n);
  Columns<K> directions = Columns<K>::Zero(K, n);
  Columns<K> products(K, n);
  const auto norms = [&]() -> DoubleRow<K>
  {
    return sumOverRows<K>(n, [&](int i) -> DoubleRow<K> { return residuals.col(i).square(); }).sqrt();
  };
  Preconditioner<K> preconditioner(this->Levels);
  DoubleRow<K> norm = norms();
  const DoubleRow<K> enough = tolerance * norm;
  DoubleRow<K> previous = DoubleRow<K>::Zero();
  for (int k = 0; k < MostCycles && (norm > enough).any(); ++k)
  {
    report(progress, 0.0, CyclesStage);
    ++this->Iterations;
    preconditioner.compute(residuals, norm);
    const DoubleRow<K> descent =
      sumOverRows<K>(n, [&](int i) -> DoubleRow<K> { return residuals.col(i) * preconditioner.row(i); });
    const DoubleRow<K> share = (previous > 0.0).select(descent / previous, 0.0);
    previous = descent;
    forRows(n,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          directions.col(i) = preconditioner.row(i) + share * directions.col(i);
        }
      });
    const DoubleRow<K> curvature = sumOverRows<K>(n,
      [&](int i) -> DoubleRow<K>
      {
        products.col(i) = rowTimes<K>(this->Matrix, i, directions);
        return directions.col(i) * products.col(i);
      });
    // A system that is solved has no direction left.
    const DoubleRow<K> length = (norm > enough).select(descent / curvature, 0.0);
    if (!(length >= 0.0).all())
    {
      return false;
    }
    forRows(n,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          found.col(i) += length * directions.col(i);
          residuals.col(i) -= length * products.col(i);
        }
      });
    norm = norms();
  }
  solutions = found.transpose().matrix();
  return !(norm > enough).any();
}

} // namespace flattening
