// SPDX-License-Identifier: GPL-3.0-or-later
/// The second derivative of an energy of a lattice's nodes.
#pragma once

#include "Areas/DeformationLattice.h"
#include "Base/SparseFactorization.h"

#include <Eigen/Core>

#include <array>

namespace flattening
{

/// A symmetric matrix with two unknowns per node of a lattice, x and y of each node in turn, as a sum of
/// matrices of single squares. Its pattern, which couples any two nodes that move a point in common, is
/// found once.
class LatticeMatrix
{
public:
  /// A matrix of the nine nodes that move a square, of which the lower triangle counts.
  using SquareBlock = Eigen::Matrix<double, 18, 18>;

  /// Zero.
  explicit LatticeMatrix(const DeformationLattice& lattice);

  /// Sets all entries to zero and keeps the pattern.
  void setZero();

  /// Adds the matrix of a square with the nodes @p nodes (DeformationLattice::Influence).
  void add(const std::array<int, 9>& nodes, const SquareBlock& block);

  /// The lower triangle.
  SparseMatrix& lower() { return this->Lower; }

private:
  // How many columns of nodes to the left and to the right of a node are coupled with it.
  struct Reach
  {
    int Left;
    int Right;
  };
  Reach reachOf(int node) const;

  int Columns; // of nodes
  SparseMatrix Lower;
};

} // namespace flattening
