// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Multigrid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{

// The greatest number of unknowns of the coarsest level, which is factored. With twice as many the times
// are the same.
constexpr int MostCoarsest = 10000;
// A neighbour is strong if the square of its entry is at least this share of the product of both
// diagonal entries. A sixth of it and four times as much took as many iterations on half a brain; with
// 25 times as much, groups are so small that the levels hardly shrink.
constexpr float LeastStrength = 0.0025F;
// Share of a step of Jacobi's method by which the prolongation is smoothed. The usual value; 0.8 and 0.9
// take as many iterations.
constexpr double Damping = 2.0 / 3.0;
// A level with more than this share of the unknowns of the one before is not worth a cycle.
constexpr double MostOfALevel = 0.7;
// The smoother reduces errors of eigenvalues from the greatest one down to the greatest one divided by
// this ratio. With 6 and with 20, a cycle reduces errors as much.
constexpr float SmoothedRange = 10.0F;
constexpr const char* LevelsStage = "Levels of a linear system";

bool isStrong(const RowMatrix& a, const std::vector<float>& diagonal, int row, int entry)
{
  const int column = a.Column[entry];
  return column != row &&
         a.Value[entry] * a.Value[entry] >= LeastStrength * diagonal[row] * diagonal[column];
}

// Groups of strong neighbours. Every unknown belongs to one.
struct Groups
{
  std::vector<int> Of;
  int Count = 0;
};

Groups groupsOf(const RowMatrix& a, const std::vector<float>& diagonal)
{
  const int n = a.rows();
  Groups groups;
  groups.Of.assign(n, -1);
  const auto forStrong = [&](int i, const auto& function)
  {
    for (int e = a.Begin[i]; e < a.Begin[i + 1]; ++e)
    {
      if (isStrong(a, diagonal, i, e))
      {
        function(a.Column[e], std::abs(a.Value[e]));
      }
    }
  };
  // An unknown and its neighbours, where none of them belongs to a group.
  for (int i = 0; i < n; ++i)
  {
    bool isFree = groups.Of[i] < 0;
    forStrong(i, [&](int j, float) { isFree = isFree && groups.Of[j] < 0; });
    if (isFree)
    {
      groups.Of[i] = groups.Count;
      forStrong(i, [&](int j, float) { groups.Of[j] = groups.Count; });
      ++groups.Count;
    }
  }
  // The others join the group of their strongest neighbour that belongs to one.
  const std::vector<int> first = groups.Of;
  for (int i = 0; i < n; ++i)
  {
    if (first[i] < 0)
    {
      float strongest = 0.0F;
      forStrong(i,
        [&](int j, float strength)
        {
          if (first[j] >= 0 && strength > strongest)
          {
            strongest = strength;
            groups.Of[i] = first[j];
          }
        });
    }
  }
  return groups;
}

// The prolongation that is constant in each group, smoothed by a step of Jacobi's method for the matrix
// whose weak entries are added to its diagonal.
RowMatrix smoothedProlongation(const RowMatrix& a, const std::vector<float>& diagonal)
{
  const Groups groups = groupsOf(a, diagonal);
  return matrixOfRows(a.rows(),
    groups.Count,
    [&](int i, RowSum& sum)
    {
      double own = 0.0; // entry of the diagonal
      for (int e = a.Begin[i]; e < a.Begin[i + 1]; ++e)
      {
        own += isStrong(a, diagonal, i, e) ? 0.0 : a.Value[e];
      }
      sum.add(groups.Of[i], 1.0 - Damping);
      for (int e = a.Begin[i]; e < a.Begin[i + 1]; ++e)
      {
        if (isStrong(a, diagonal, i, e))
        {
          sum.add(groups.Of[a.Column[e]], -Damping * a.Value[e] / own);
        }
      }
    });
}

std::vector<float> diagonalOf(const RowMatrix& a)
{
  std::vector<float> diagonal(a.rows(), 0.0F);
  for (int i = 0; i < a.rows(); ++i)
  {
    for (int e = a.Begin[i]; e < a.Begin[i + 1]; ++e)
    {
      diagonal[i] += a.Column[e] == i ? a.Value[e] : 0.0F;
    }
  }
  return diagonal;
}

// Gershgorin's bound for the matrix with its diagonal scaled to 1.
float greatestEigenvalue(const RowMatrix& a, const std::vector<float>& diagonal)
{
  float greatest = 0.0F;
  for (int i = 0; i < a.rows(); ++i)
  {
    float sum = 0.0F;
    for (int e = a.Begin[i]; e < a.Begin[i + 1]; ++e)
    {
      sum += std::abs(a.Value[e]);
    }
    greatest = std::max(greatest, sum / diagonal[i]);
  }
  return greatest;
}

SparseMatrix lowerTriangle(const RowMatrix& a)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < a.rows(); ++i)
  {
    for (int e = a.Begin[i]; e < a.Begin[i + 1] && a.Column[e] <= i; ++e)
    {
      entries.emplace_back(i, a.Column[e], a.Value[e]);
    }
  }
  SparseMatrix matrix(a.rows(), a.rows());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

template <int K>
using FloatRow = Eigen::Array<float, K, 1>;

template <int K>
FloatRow<K> rowOf(const std::vector<float>& values, int i)
{
  return Eigen::Map<const FloatRow<K>>(values.data() + static_cast<std::size_t>(i) * K);
}

template <int K>
Eigen::Map<FloatRow<K>> rowOf(std::vector<float>& values, int i)
{
  return Eigen::Map<FloatRow<K>>(values.data() + static_cast<std::size_t>(i) * K);
}

template <int K>
FloatRow<K> rowTimes(const RowMatrix& a, int i, const std::vector<float>& x)
{
  FloatRow<K> sum = FloatRow<K>::Zero();
  for (int e = a.Begin[i]; e < a.Begin[i + 1]; ++e)
  {
    sum += a.Value[e] * rowOf<K>(x, a.Column[e]);
  }
  return sum;
}

// result = function(i, row i of a times x), for every row i
template <int K, class F>
void forProducts(const RowMatrix& a,
  const std::vector<float>& x,
  std::vector<float>& result,
  const F& function)
{
  result.resize(static_cast<std::size_t>(a.rows()) * K);
  forRows(a.rows(),
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        rowOf<K>(result, i) = function(i, rowTimes<K>(a, i, x));
      }
    });
}

} // namespace

bool Multigrid::compute(RowMatrix matrix, const ProgressCallback& progress)
{
  this->Levels.clear();
  bool isCoarse = false;
  while (!isCoarse)
  {
    report(progress, 0.0, LevelsStage);
    Level level;
    level.Matrix = std::move(matrix);
    level.Diagonal = diagonalOf(level.Matrix);
    if (!(*std::min_element(level.Diagonal.begin(), level.Diagonal.end()) > 0.0F))
    {
      return false;
    }
    level.GreatestEigenvalue = greatestEigenvalue(level.Matrix, level.Diagonal);
    level.Prolongation = smoothedProlongation(level.Matrix, level.Diagonal);
    level.Restriction = transposed(level.Prolongation);
    matrix = product(level.Restriction, product(level.Matrix, level.Prolongation));
    isCoarse = matrix.rows() <= MostCoarsest || matrix.rows() > MostOfALevel * level.Matrix.rows();
    this->Levels.push_back(std::move(level));
  }
  this->Coarsest.compute(lowerTriangle(matrix));
  return this->Coarsest.info() == Eigen::Success;
}

template <int K>
std::vector<float>& Multigrid::rightSides()
{
  std::vector<float>& values = this->Levels.front().RightSide;
  values.resize(static_cast<std::size_t>(this->rows()) * K);
  return values;
}

template <int K>
const std::vector<float>& Multigrid::cycle()
{
  this->cycleFrom<K>(0);
  return this->Levels.front().Solution;
}

template <int K>
void Multigrid::cycleFrom(std::size_t number)
{
  Level& level = this->Levels[number];
  smooth<K>(level, true);
  std::vector<float>& residual = level.Step;
  forProducts<K>(level.Matrix,
    level.Solution,
    residual,
    [&](int i, const FloatRow<K>& product) -> FloatRow<K>
    { return rowOf<K>(level.RightSide, i) - product; });
  const bool isLast = number + 1 == this->Levels.size();
  std::vector<float> coarsest;
  forProducts<K>(level.Restriction,
    residual,
    isLast ? coarsest : this->Levels[number + 1].RightSide,
    [](int, const FloatRow<K>& product) { return product; });
  if (isLast)
  {
    this->solveCoarsest<K>(coarsest);
  }
  else
  {
    this->cycleFrom<K>(number + 1);
  }
  forProducts<K>(level.Prolongation,
    isLast ? coarsest : this->Levels[number + 1].Solution,
    level.Next,
    [&](int i, const FloatRow<K>& product) -> FloatRow<K>
    { return rowOf<K>(level.Solution, i) + product; });
  std::swap(level.Solution, level.Next);
  smooth<K>(level, false);
}

template <int K>
void Multigrid::solveCoarsest(std::vector<float>& values) const
{
  Eigen::Map<Eigen::Matrix<float, Eigen::Dynamic, K, K == 1 ? Eigen::ColMajor : Eigen::RowMajor>> all(
    values.data(), static_cast<Eigen::Index>(values.size()) / K, K);
  const Eigen::MatrixXd rightSides = all.template cast<double>();
  all = this->Coarsest.solve(rightSides).template cast<float>();
}

// Two steps of Chebyshev's iteration (e.g. Saad 2003, "Iterative methods for sparse linear systems",
// algorithm 12.1) with the diagonal as preconditioner, which do not depend on the order of the unknowns
// as those of Gauss and Seidel do.
template <int K>
void Multigrid::smooth(Level& level, bool fromZero)
{
  const float middle = 0.5F * level.GreatestEigenvalue * (1.0F + 1.0F / SmoothedRange);
  const float radius = 0.5F * level.GreatestEigenvalue * (1.0F - 1.0F / SmoothedRange);
  const float next = 1.0F / (2.0F * middle / radius - radius / middle);
  level.Step.resize(level.RightSide.size());
  level.Solution.resize(level.RightSide.size());
  if (fromZero)
  {
    forRows(level.Matrix.rows(),
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          rowOf<K>(level.Step, i) = rowOf<K>(level.RightSide, i) / (middle * level.Diagonal[i]);
          rowOf<K>(level.Solution, i) = rowOf<K>(level.Step, i);
        }
      });
  }
  const auto step = [&](float ofStep, float ofResidual)
  {
    forProducts<K>(level.Matrix,
      level.Solution,
      level.Next,
      [&](int i, const FloatRow<K>& product) -> FloatRow<K>
      {
        Eigen::Map<FloatRow<K>> own = rowOf<K>(level.Step, i);
        const FloatRow<K> residual = rowOf<K>(level.RightSide, i) - product;
        own = (ofStep == 0.0F ? FloatRow<K>::Zero() : FloatRow<K>(ofStep * own)) +
              ofResidual / level.Diagonal[i] * residual;
        return rowOf<K>(level.Solution, i) + own;
      });
    std::swap(level.Solution, level.Next);
  };
  if (!fromZero)
  {
    step(0.0F, 1.0F / middle);
  }
  step(next * radius / middle, 2.0F * next / radius);
}

template std::vector<float>& Multigrid::rightSides<1>();
template std::vector<float>& Multigrid::rightSides<2>();
template const std::vector<float>& Multigrid::cycle<1>();
template const std::vector<float>& Multigrid::cycle<2>();

} // namespace flattening
