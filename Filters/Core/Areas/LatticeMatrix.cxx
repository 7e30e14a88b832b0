// SPDX-License-Identifier: GPL-3.0-or-later
#include "Areas/LatticeMatrix.h"

#include <algorithm>

namespace flattening
{
namespace
{

// Nodes are coupled if they are at most so many columns and rows of nodes from each other: quadratic
// B-splines span three squares.
constexpr int CouplingDistance = 2;

} // namespace

// The rows of a column of the matrix are those of the node itself, of nodes to its right, and of those
// in the next two rows of nodes.
LatticeMatrix::LatticeMatrix(const DeformationLattice& lattice)
  : Columns(lattice.columns() + 2)
  , Lower(2 * lattice.nodeCount(), 2 * lattice.nodeCount())
{
  constexpr int most =
    2 * (CouplingDistance + 1 + CouplingDistance * (2 * CouplingDistance + 1)); // rows of a column
  this->Lower.reserve(Eigen::VectorXi::Constant(this->Lower.cols(), most));
  for (int node = 0; node < lattice.nodeCount(); ++node)
  {
    const auto [left, right] = this->reachOf(node);
    const int rowsBelow = (lattice.nodeCount() - 1 - node) / this->Columns;
    for (int row = 0; row <= std::min(CouplingDistance, rowsBelow); ++row)
    {
      for (int k = row == 0 ? 0 : -left; k <= right; ++k)
      {
        const int coupled = 2 * (node + row * this->Columns + k);
        for (int i = 0; i < 4; ++i)
        {
          if (coupled + i / 2 >= 2 * node + i % 2)
          {
            this->Lower.insert(coupled + i / 2, 2 * node + i % 2) = 0.0;
          }
        }
      }
    }
  }
  this->Lower.makeCompressed();
}

LatticeMatrix::Reach LatticeMatrix::reachOf(int node) const
{
  const int column = node % this->Columns;
  return { std::min(CouplingDistance, column), std::min(CouplingDistance, this->Columns - 1 - column) };
}

void LatticeMatrix::setZero()
{
  std::fill_n(this->Lower.valuePtr(), this->Lower.nonZeros(), 0.0);
}

void LatticeMatrix::add(const std::array<int, 9>& nodes, const SquareBlock& block)
{
  for (int c = 0; c < 9; ++c)
  {
    const auto [left, right] = this->reachOf(nodes[c]);
    double* first = this->Lower.valuePtr() + this->Lower.outerIndexPtr()[2 * nodes[c]];
    double* second = this->Lower.valuePtr() + this->Lower.outerIndexPtr()[2 * nodes[c] + 1] - 1;
    for (int r = c; r < 9; ++r)
    {
      const int row = r / 3 - c / 3;
      const int place =
        r % 3 - c % 3 + row * (left + 1 + right); // among the nodes coupled with this one
      first[2 * place] += block(2 * r, 2 * c);
      first[2 * place + 1] += block(2 * r + 1, 2 * c);
      second[2 * place + 1] += block(2 * r + 1, 2 * c + 1);
      if (r > c) // the second column begins with the second row
      {
        second[2 * place] += block(2 * r, 2 * c + 1);
      }
    }
  }
}

} // namespace flattening
