// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/ConformalStrain.h"

#include "Intrinsic/IntrinsicTriangulation.h"

#include <cmath>
#include <utility>

namespace flattening
{
namespace
{

constexpr const char* StrainStage = "Strain of the flat map";

} // namespace

ConformalStrain::Solver::Solver()
  : SparseCholesky(EliminationOrder(), Kernel::Entries)
{
  this->expectConstantPattern();
}

ConformalStrain::ConformalStrain(const TriangleMesh& mesh)
  : Curvature(Eigen::VectorXd::Constant(mesh.vertexCount(), 2.0 * std::acos(-1.0)))
  , Area(vertexAreas(mesh))
  , Laplacian(mesh.vertexCount(), mesh.vertexCount())
{
  IntrinsicTriangulation surface(mesh);
  surface.flipToDelaunay();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * static_cast<std::size_t>(surface.halfedgeCount()));
  for (int f = 0; f < surface.faceCount(); ++f)
  {
    // Side k is opposite to corner k + 2.
    const TriangleAngles angles = triangleAngles(
      surface.logLength(3 * f), surface.logLength(3 * f + 1), surface.logLength(3 * f + 2));
    for (int k = 0; k < 3; ++k)
    {
      const int i = surface.origin(3 * f + k);
      const int j = surface.tip(3 * f + k);
      const double weight = 0.5 * angles.Cotangent[k];
      this->Curvature[surface.origin(IntrinsicTriangulation::previous(3 * f + k))] -= angles.Angle[k];
      entries.emplace_back(i, i, weight);
      entries.emplace_back(j, j, weight);
      entries.emplace_back(i, j, -weight);
      entries.emplace_back(j, i, -weight);
    }
  }
  this->Laplacian.setFromTriplets(entries.begin(), entries.end());
}

Eigen::VectorXd ConformalStrain::conformalFactors(const std::vector<char>& outline,
  const ProgressCallback& progress) const
{
  // The factors of the outline stay among the unknowns, each with an equation of its own, so that the
  // pattern of the matrix is always the same.
  SparseMatrix matrix = this->Laplacian;
  Eigen::VectorXd curvature = -this->Curvature;
  for (int v = 0; v < matrix.cols(); ++v)
  {
    for (SparseMatrix::InnerIterator entry(matrix, v); entry; ++entry)
    {
      if (outline[v] || outline[entry.row()])
      {
        entry.valueRef() = entry.row() == v ? 1.0 : 0.0;
      }
    }
    curvature[v] = outline[v] ? 0.0 : curvature[v];
  }
  SparseCholesky& cholesky = this->Solvers.local();
  cholesky.compute(std::move(matrix), progress, 0.0, StrainStage);
  if (cholesky.info() != Eigen::Success)
  {
    throw ConvergenceError("the strain of the surface could not be computed, as the cotangent Laplacian "
                           "could not be factored: remesh the surface");
  }
  return cholesky.solve(curvature);
}

double ConformalStrain::of(const Eigen::VectorXd& factors) const
{
  const double whole = this->Area.sum();
  const double mean = this->Area.dot(factors) / whole;
  return std::sqrt(this->Area.dot((factors.array() - mean).square().matrix()) / whole);
}

} // namespace flattening
