// SPDX-License-Identifier: GPL-3.0-or-later
/// Smooth deformations of the plane, by quadratic B-splines on a lattice of squares.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>

namespace flattening
{

/// A lattice of squares of equal size. A deformation moves the point x by the sum over the nodes of the
/// displacement of the node (a row of an k x 2 matrix) times the product of two quadratic B-splines
/// (Farin 2002, chapter 10). It has continuous first derivatives, and a point moves with the 9 nodes
/// around it alone.
class DeformationLattice
{
public:
  /// The nodes that move a point, and their weights there.
  struct Influence
  {
    std::array<int, 9> Nodes;
    std::array<double, 9> Weights;            ///< sum 1
    std::array<Eigen::Vector2d, 9> Gradients; ///< of the weights, by the point; sum 0
  };

  /// A lattice that covers @p box with squares, @p squares (>= 1) of them along its longer side.
  DeformationLattice(const Eigen::AlignedBox2d& box, int squares);

  const Eigen::Vector2d& origin() const { return this->Origin; } ///< the lower left corner
  int columns() const { return this->Columns; }                  ///< number of squares along x
  int rows() const { return this->Rows; }                        ///< number of squares along y
  double side() const { return this->Side; }                     ///< of a square
  int nodeCount() const { return (this->Columns + 2) * (this->Rows + 2); }

  /// @p point must lie in the box.
  Influence influenceOn(const Eigen::Vector2d& point) const;

  /// @p points (n x 2, in the box) moved by the nodes' @p displacements (nodeCount() x 2).
  Points2 moved(const Points2& points, const Points2& displacements) const;

private:
  Eigen::Vector2d Origin;
  double Side;
  int Columns;
  int Rows;
};

} // namespace flattening
