// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/GraphLaplacian.h"

#include "Base/Errors.h"
#include "Base/SparseFactorization.h"

#include <algorithm>
#include <utility>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
// Rounds of correction by the residual after the first solution. A round costs one solution, little
// beside the factor; without any, vertices that lie much closer together than others lose the digits of
// their distances.
constexpr int Refinements = 2;
constexpr const char* Stage = "Layout";

} // namespace

void relaxSprings(const std::vector<Spring>& springs,
  const std::vector<char>& fixed,
  ComplexVector& position,
  const ProgressCallback& progress)
{
  report(progress, 0.0, Stage);
  std::vector<int> row(fixed.size(), -1);
  std::vector<int> vertex;
  for (std::size_t v = 0; v < fixed.size(); ++v)
  {
    if (!fixed[v])
    {
      row[v] = static_cast<int>(vertex.size());
      vertex.push_back(static_cast<int>(v));
    }
  }
  if (vertex.empty())
  {
    return;
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * springs.size());
  for (const Spring& s : springs)
  {
    const int i = row[s.From];
    const int j = row[s.To];
    for (const int k : { i, j })
    {
      if (k >= 0)
      {
        entries.emplace_back(k, k, s.Weight);
      }
    }
    if (i >= 0 && j >= 0)
    {
      entries.emplace_back(std::max(i, j), std::min(i, j), -s.Weight);
    }
  }
  SparseMatrix laplacian(vertex.size(), vertex.size());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  SparseCholesky cholesky(SparseCholesky::Ordering::Quick);
  cholesky.compute(std::move(laplacian), progress, 0.2, Stage);
  if (cholesky.info() != Eigen::Success)
  {
    throw ConvergenceError(
      "the flat metric could not be laid out: remesh the surface (Surface To Disk, Remesh)");
  }
  // Forces are sums of differences: refined by them, positions are as good as the springs' weights.
  for (int round = 0; round < 1 + Refinements; ++round)
  {
    report(progress, 0.8 + 0.2 * round / (1 + Refinements), Stage);
    Eigen::MatrixX2d force = Eigen::MatrixX2d::Zero(vertex.size(), 2);
    for (const Spring& s : springs)
    {
      const Complex pull = s.Weight * (position[s.To] - position[s.From]);
      const Eigen::RowVector2d f(pull.real(), pull.imag());
      if (row[s.From] >= 0)
      {
        force.row(row[s.From]) += f;
      }
      if (row[s.To] >= 0)
      {
        force.row(row[s.To]) -= f;
      }
    }
    const Eigen::MatrixX2d change = cholesky.solve(force);
    for (std::size_t i = 0; i < vertex.size(); ++i)
    {
      position[vertex[i]] += Complex(change(i, 0), change(i, 1));
    }
  }
}

} // namespace flattening
