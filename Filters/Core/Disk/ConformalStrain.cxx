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
  std::vector<int> row(outline.size(), -1);
  std::vector<int> inner;
  for (std::size_t v = 0; v < outline.size(); ++v)
  {
    if (!outline[v])
    {
      row[v] = static_cast<int>(inner.size());
      inner.push_back(static_cast<int>(v));
    }
  }
  Eigen::VectorXd factors = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(outline.size()));
  if (inner.empty())
  {
    return factors;
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(this->Laplacian.nonZeros()));
  for (const int v : inner)
  {
    for (SparseMatrix::InnerIterator entry(this->Laplacian, v); entry; ++entry)
    {
      if (row[entry.row()] >= 0)
      {
        entries.emplace_back(row[entry.row()], row[v], entry.value());
      }
    }
  }
  SparseMatrix matrix(static_cast<Eigen::Index>(inner.size()), static_cast<Eigen::Index>(inner.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  SparseCholesky cholesky(SparseCholesky::Ordering::Quick);
  cholesky.compute(std::move(matrix), progress, 0.0, StrainStage);
  if (cholesky.info() != Eigen::Success)
  {
    throw ConvergenceError("the strain of the surface could not be computed, as the cotangent Laplacian "
                           "could not be factored: remesh the surface");
  }
  factors(inner) = -cholesky.solve(this->Curvature(inner).eval());
  return factors;
}

double ConformalStrain::of(const Eigen::VectorXd& factors) const
{
  const double whole = this->Area.sum();
  const double mean = this->Area.dot(factors) / whole;
  return std::sqrt(this->Area.dot((factors.array() - mean).square().matrix()) / whole);
}

} // namespace flattening
