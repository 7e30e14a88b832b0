// SPDX-License-Identifier: GPL-3.0-or-later
/// The convex energy that discrete Ricci flow minimises: its gradient and its Hessian.
#pragma once

#include "Base/SparseFactorization.h"
#include "Intrinsic/IntrinsicTriangulation.h"

#include <vector>

namespace flattening
{

/// The angle sum (radians) of every vertex in a flat metric with a straight boundary: 2 pi inside, pi on
/// the boundary.
Eigen::VectorXd flatAngleSums(const IntrinsicTriangulation& triangulation);

/// The energy's derivatives at given conformal factors. The unknowns are the factors of the vertices
/// that are not fixed, in the order of the vertices.
class CurvatureSystem
{
public:
  /// Both references must outlive the system.
  /// @param targetAngles  wanted angle sum of every vertex (radians)
  /// @param fixed         one flag per vertex, not 0 if its factor keeps its value
  CurvatureSystem(const IntrinsicTriangulation& triangulation,
    const Eigen::VectorXd& targetAngles,
    const std::vector<char>& fixed);

  void setFixed(const std::vector<char>& fixed);
  int unknowns() const { return static_cast<int>(this->Vertex.size()); }

  /// Measures angles and cotangents at factors @p u, for which the triangulation must be Delaunay. All
  /// of the following functions refer to the last call.
  void evaluate(const IntrinsicTriangulation::Factors& u);

  /// Target minus angle sum of every unknown's vertex (radians).
  const Eigen::VectorXd& gradient() const { return this->Gradient; }
  /// The greatest absolute entry of the gradient.
  double error() const { return this->Gradient.lpNorm<Eigen::Infinity>(); }
  /// The vertices whose angle sums differ from their targets by more than @p error.
  std::vector<int> verticesOffBy(double error) const;
  /// Number of triangles and mirror cells without an interior.
  int degenerateFaces() const { return this->DegenerateFaces; }

  /// The lower triangle of the Hessian, half the cotangent Laplacian.
  SparseMatrix hessian() const;

  /// The greatest change by @p step of the difference between the factors at the ends of an edge.
  double greatestDifference(const Eigen::VectorXd& step) const;

  /// Adds @p length times @p step to the unknowns among the factors @p u.
  /// The order of the vertices of an order of the unknowns; empty if that is of other unknowns.
  EliminationOrder vertexOrder(EliminationOrder order) const;
  void addTo(IntrinsicTriangulation::Factors& u, const Eigen::VectorXd& step, double length) const;

private:
  void subtract(int vertex, double angle);

  const IntrinsicTriangulation& Triangulation;
  const Eigen::VectorXd& TargetAngles;
  std::vector<int> Row;    // unknown of every vertex; -1 if fixed
  std::vector<int> Vertex; // vertex of every unknown
  Eigen::VectorXd Gradient;
  std::vector<TriangleAngles> Angles;
  std::vector<double> BoundaryCotangents; // of the mirror cells
  int DegenerateFaces = 0;
};

} // namespace flattening
