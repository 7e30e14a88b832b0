// SPDX-License-Identifier: GPL-3.0-or-later
/// How much a surface that is cut open along given vertices must be strained to become flat.
#pragma once

#include "Base/Progress.h"
#include "Base/SparseFactorization.h"
#include "Mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace flattening
{

/// The conformal factors u of the map with a free outline: the flat metric e^(2u) g that keeps the
/// lengths of the outline, on which u = 0. Of all conformal maps this one has the least Dirichlet energy
/// of u (Springborn, Schroeder, Pinkall 2008, "Conformal equivalence of triangle meshes"; Sawhney, Crane
/// 2017, "Boundary first flattening", section 6.1). It solves the Poisson equation, Laplacian of u =
/// Gaussian curvature, with the cotangents and the angle defects of the intrinsic Delaunay
/// triangulation.
///
/// The strain is the standard deviation of the factors over the area of the surface, without unit. A map
/// that keeps all areas must stretch each place by e^s one way and e^-s the other, and the root mean
/// square of s is about this number. (Derivation for small factors: the displacement that evens the
/// areas out is the gradient of a potential p with Laplacian -2 (u - mean u), and the integral of the
/// squared traceless part of its second derivatives is half of that of the squared Laplacian.)
class ConformalStrain
{
public:
  explicit ConformalStrain(const TriangleMesh& mesh);

  /// Cuts the surface open at the flagged vertices, to which its boundary belongs.
  /// @param outline  one flag per vertex, at least one of them set on each component
  /// @throws ConvergenceError if the system cannot be factored; Cancelled.
  void open(const std::vector<char>& outline, const ProgressCallback& progress = {});

  /// The factors (n) and the strain of the surface that is cut open so.
  const Eigen::VectorXd& conformalFactors() const { return this->Factors; }
  double strain() const { return this->strainOf(this->Factors); }

  /// The strains if the surface were cut open at the vertices of one of the @p paths as well, for each
  /// of them. The system need not be factored again: the factors change by that combination of the
  /// columns of the inverse matrix that makes them 0 on the path.
  std::vector<double> strainsWith(const std::vector<std::vector<int>>& paths) const;

private:
  double strainOf(const Eigen::VectorXd& factors) const;

  Eigen::VectorXd Curvature; // angle defect of every vertex, radians; without meaning on the boundary
  Eigen::VectorXd Area;      // of every vertex, input units squared
  SparseMatrix Laplacian;    // positive semi-definite
  SparseCholesky Cholesky;   // of the Laplacian whose rows and columns of the outline are 0 but for a 1
  Eigen::VectorXd Factors;
};

} // namespace flattening
