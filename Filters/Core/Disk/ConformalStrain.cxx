// SPDX-License-Identifier: GPL-3.0-or-later
#include "Disk/ConformalStrain.h"

#include "Base/Errors.h"
#include "Intrinsic/IntrinsicTriangulation.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <utility>

namespace flattening
{
namespace
{

constexpr const char* StrainStage = "Strain of the flat map";

} // namespace

ConformalStrain::ConformalStrain(const TriangleMesh& mesh)
  : Curvature(Eigen::VectorXd::Constant(mesh.vertexCount(), 2.0 * std::acos(-1.0)))
  , Area(vertexAreas(mesh))
  , Laplacian(mesh.vertexCount(), mesh.vertexCount())
  , Cholesky(EliminationOrder(), SparseCholesky::Kernel::Entries)
{
  this->Cholesky.expectConstantPattern();
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

void ConformalStrain::open(const std::vector<char>& outline, const ProgressCallback& progress)
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
  this->Cholesky.compute(std::move(matrix), progress, 0.0, StrainStage);
  if (this->Cholesky.info() != Eigen::Success)
  {
    throw ConvergenceError("the strain of the surface could not be computed, as the cotangent Laplacian "
                           "could not be factored: remesh the surface");
  }
  this->Factors = this->Cholesky.solve(curvature);
}

std::vector<double> ConformalStrain::strainsWith(const std::vector<std::vector<int>>& paths) const
{
  const auto count = static_cast<Eigen::Index>(paths.size());
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(this->Factors.size(), count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const std::vector<int>& path = paths[i];
    const Eigen::VectorXd shares = this->Cholesky.inverseAt(path).ldlt().solve(this->Factors(path));
    changes(path, i) = shares;
  }
  changes = this->Cholesky.solve(changes);
  std::vector<double> strains;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    strains.push_back(this->strainOf(this->Factors - changes.col(i)));
  }
  return strains;
}

double ConformalStrain::strainOf(const Eigen::VectorXd& factors) const
{
  const double whole = this->Area.sum();
  const double mean = this->Area.dot(factors) / whole;
  return std::sqrt(this->Area.dot((factors.array() - mean).square().matrix()) / whole);
}

} // namespace flattening
