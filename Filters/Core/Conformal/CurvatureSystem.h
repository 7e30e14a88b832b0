// SPDX-License-Identifier: GPL-3.0-or-later
/// The energy that discrete Ricci flow minimises: its gradient and Hessian.
#pragma once

#include "Base/SparseFactorization.h"
#include "Intrinsic/IntrinsicTriangulation.h"

#include <vector>

namespace flattening
{

/// At one choice of conformal factors. Unknowns are the factors of the vertices that are not fixed.
class CurvatureSystem
{
public:
  /// @param targetAngles  wanted angle sum of every vertex (radians)
  CurvatureSystem(const IntrinsicTriangulation& triangulation,
    const Eigen::VectorXd& targetAngles,
    const std::vector<char>& fixed);

  void setFixed(const std::vector<char>& fixed);
  int unknowns() const { return static_cast<int>(this->Vertex.size()); }

  /// Measures angles and cotangents at factors @p u, for which the triangulation must be Delaunay.
  void evaluate(const IntrinsicTriangulation::Factors& u);

  /// Of the last evaluate(): target - angle sum per unknown; and the number of triangles and mirror
  /// cells without an interior.
  const Eigen::VectorXd& gradient() const { return this->Gradient; }
  double error() const { return this->Gradient.lpNorm<Eigen::Infinity>(); }
  std::vector<int> verticesOffBy(double error) const; ///< by more than that
  int degenerateFaces() const { return this->DegenerateFaces; }

  /// The lower half of the Hessian, half the cotangent Laplacian.
  SparseMatrix hessian() const;

  /// The vertices of unknowns.
  std::vector<int> vertices(const std::vector<int>& unknowns) const;

  /// Of the factors at the ends of an edge, that @p step changes.
  double greatestDifference(const Eigen::VectorXd& step) const;

  void addTo(IntrinsicTriangulation::Factors& u, const Eigen::VectorXd& step, double length) const;

private:
  void subtract(int vertex, double angle);

  const IntrinsicTriangulation& Triangulation;
  const Eigen::VectorXd& TargetAngles;
  std::vector<int> Row;
  std::vector<int> Vertex;
  Eigen::VectorXd Gradient;
  std::vector<TriangleAngles> Angles;
  std::vector<double> BoundaryCotangents; // of the mirror cells
  int DegenerateFaces = 0;
};

} // namespace flattening
