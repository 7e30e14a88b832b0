// SPDX-License-Identifier: GPL-3.0-or-later
/// Positions in the plane of which all but fixed ones are weighted means of their neighbours: the
/// Dirichlet problem of a graph's Laplacian.
#pragma once

#include "Base/MultigridSolver.h"
#include "Base/Progress.h"
#include "Base/SparseFactorization.h"
#include "Mesh/ComplexPositions.h"

#include <memory>
#include <optional>
#include <vector>

namespace flattening
{

/// The weight of vertex To in the mean that vertex From is: >= 0, in any unit that all weights of From
/// share. Weights of the same pair add up.
struct NeighbourWeight
{
  int From;
  int To;
  double Weight;
};

/// Whether the weights of every two free vertices in each other's mean are equal, which saves half of
/// the time.
enum class WeightSymmetry
{
  Symmetric,
  General
};

/// The factored system of equations by which every free vertex is the weighted mean of its neighbours.
/// Within a convex boundary no triangle of a planar triangulation is flipped if all weights are positive
/// (Tutte 1963; Floater 2003, "One-to-one piecewise linear mappings over triangulations", theorem 4.1).
class WeightedMeans
{
public:
  /// @param weights  weights of fixed vertices are not used; positive weights must connect every free
  ///                 vertex with a fixed one
  /// @param fixed  one flag per vertex
  /// @param order  the vertices in an order of elimination for nearly the same neighbours, fixed ones
  ///               included; empty to look for one
  /// @throws ConvergenceError if the matrix cannot be factored; Cancelled.
  WeightedMeans(std::vector<NeighbourWeight> weights,
    WeightSymmetry symmetry,
    const std::vector<char>& fixed,
    const ProgressCallback& progress = {},
    const EliminationOrder& order = {});

  /// Moves the free vertices to the means of their neighbours. The closer they are to that before, the
  /// smaller are the rounding errors. @throws ConvergenceError, Cancelled.
  void extend(ComplexVector& positions, const ProgressCallback& progress = {});

  /// The potential (n) of which the Laplacian, by the weights, is @p vertexWeights (n) at every free
  /// vertex, and which is 0 at fixed ones: each free vertex has the sum of the weighted differences from
  /// its neighbours. For symmetric weights. @throws ConvergenceError, Cancelled.
  Eigen::VectorXd potential(const Eigen::VectorXd& vertexWeights, const ProgressCallback& progress = {});

  /// The weights with which the positions of the fixed vertices give the sum of all positions, each with
  /// its own weight of @p vertexWeights (n). Only the elements of fixed vertices count.
  /// @throws ConvergenceError, Cancelled.
  Eigen::VectorXd passedToFixed(const Eigen::VectorXd& vertexWeights,
    const ProgressCallback& progress = {});

private:
  bool computeLevels(const SparseMatrix& matrix, const ProgressCallback& progress);
  void factor(SparseMatrix matrix,
    WeightSymmetry symmetry,
    const EliminationOrder& order,
    const ProgressCallback& progress);
  Eigen::MatrixXd solution(const Eigen::MatrixXd& rightSides,
    double tolerance,
    const ProgressCallback& progress);
  SparseMatrix matrix(WeightSymmetry symmetry) const;
  EliminationOrder orderOfFree(const EliminationOrder& order) const;

  std::vector<int> Row; // index of every vertex among the free ones; -1 if it is fixed
  std::vector<int> Free;
  std::vector<NeighbourWeight> Weights; // of free vertices
  // The solver: multigrid if the matrix is symmetric and large, as long as that converges, Cholesky if
  // it is small, otherwise LU.
  std::unique_ptr<MultigridSolver> Levels;
  std::optional<SparseCholesky> Cholesky;
  std::optional<SparseLu> Lu;
};

} // namespace flattening
