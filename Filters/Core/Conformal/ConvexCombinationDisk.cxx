// SPDX-License-Identifier: GPL-3.0-or-later
#include "Conformal/ConvexCombinationDisk.h"

#include "Base/Errors.h"
#include "Base/SparseFactorization.h"
#include "Conformal/BoundaryAngles.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace flattening
{
namespace
{

using Complex = std::complex<double>;
// Greatest share of the mass that one boundary vertex may carry: with half of it no Moebius map of the
// circle centres the masses, and close to that all other vertices crowd at the far side.
constexpr double GreatestShare = 0.49;
// Rounds of refinement after the first solution: one brings the rounding errors of the factorization
// down to those of the residuals. More only cost time.
constexpr int Refinements = 1;
constexpr const char* Stage = "Convex combination map";

class ConvexCombinations
{
public:
  ConvexCombinations(const std::vector<NeighbourWeight>& weights,
    WeightSymmetry symmetry,
    const std::vector<int>& loop,
    Eigen::Index vertexCount,
    const ProgressCallback& progress)
    : Loop(loop)
    , Row(vertexCount, 0)
  {
    for (const int v : loop)
    {
      this->Row[v] = -1;
    }
    for (Eigen::Index v = 0; v < vertexCount; ++v)
    {
      if (this->Row[v] == 0)
      {
        this->Row[v] = static_cast<int>(this->Inner.size());
        this->Inner.push_back(static_cast<int>(v));
      }
    }
    for (const NeighbourWeight& w : weights)
    {
      if (this->Row[w.From] >= 0 && w.Weight > 0.0)
      {
        this->Weights.push_back(w);
      }
    }
    if (!this->Inner.empty())
    {
      this->factor(symmetry, progress);
    }
  }

  // The share that every boundary vertex, in the order of the loop, has in the mean of all vertices with
  // the given weights.
  Eigen::VectorXd boundaryShares(const Eigen::VectorXd& vertexWeights) const
  {
    Eigen::VectorXd all = vertexWeights;
    if (!this->Inner.empty())
    {
      const Eigen::VectorXd inner = vertexWeights(this->Inner);
      const Eigen::VectorXd passed =
        this->Cholesky ? this->Cholesky->solve(inner) : this->Lu->solveTransposed(inner);
      for (const NeighbourWeight& w : this->Weights)
      {
        all[w.To] += this->Row[w.To] < 0 ? w.Weight * passed[this->Row[w.From]] : 0.0;
      }
    }
    const Eigen::VectorXd shares = all(this->Loop);
    return shares / shares.sum();
  }

  // The positions of all vertices for given positions of the boundary.
  ComplexVector extended(const ComplexVector& boundary) const
  {
    ComplexVector position(this->Row.size(), Complex(0.0, 0.0));
    for (std::size_t k = 0; k < this->Loop.size(); ++k)
    {
      position[this->Loop[k]] = boundary[k];
    }
    // Residuals are sums of differences, which keep their digits where neighbours are close.
    for (int round = 0; !this->Inner.empty() && round < 1 + Refinements; ++round)
    {
      Eigen::MatrixXd residual = Eigen::MatrixXd::Zero(this->Inner.size(), 2);
      for (const NeighbourWeight& w : this->Weights)
      {
        const Complex pull = w.Weight * (position[w.To] - position[w.From]);
        residual.row(this->Row[w.From]) += Eigen::RowVector2d(pull.real(), pull.imag());
      }
      const Eigen::MatrixXd change =
        this->Cholesky ? this->Cholesky->solve(residual) : this->Lu->solve(residual);
      for (std::size_t i = 0; i < this->Inner.size(); ++i)
      {
        position[this->Inner[i]] += Complex(change(i, 0), change(i, 1));
      }
    }
    return position;
  }

private:
  void factor(WeightSymmetry symmetry, const ProgressCallback& progress)
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(2 * this->Weights.size());
    for (const NeighbourWeight& w : this->Weights)
    {
      const int i = this->Row[w.From];
      entries.emplace_back(i, i, w.Weight);
      if (this->Row[w.To] >= 0)
      {
        entries.emplace_back(i, this->Row[w.To], -w.Weight);
      }
    }
    SparseMatrix matrix(this->Inner.size(), this->Inner.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (symmetry == WeightSymmetry::Symmetric)
    {
      this->Cholesky.emplace(SparseCholesky::Ordering::Quick);
      this->Cholesky->compute(std::move(matrix), progress, 0.2, Stage);
    }
    else
    {
      this->Lu.emplace(std::move(matrix), progress, 0.2, Stage);
    }
    report(progress, 0.6, Stage);
    if ((this->Cholesky ? this->Cholesky->info() : this->Lu->info()) != Eigen::Success)
    {
      throw ConvergenceError("the weights of neighbours could not be factored: remesh the surface "
                             "(Surface To Disk, Remesh)");
    }
  }

  const std::vector<int>& Loop;
  std::vector<int> Row; // index of every vertex among the inner ones; -1 on the boundary
  std::vector<int> Inner;
  std::vector<NeighbourWeight> Weights; // of inner vertices
  // The factors of the matrix: Cholesky if it is symmetric, otherwise LU.
  std::optional<SparseCholesky> Cholesky;
  std::optional<SparseLu> Lu;
};

// The map after the boundary has been moved by the Moebius map that centres the boundary's shares.
ComplexVector centredByBoundary(const ConvexCombinations& combinations,
  const Eigen::VectorXd& angles,
  const Eigen::VectorXd& shares)
{
  const ComplexVector halfPlane = halfPlaneBoundary(angles);
  ComplexVector circle = cayley(halfPlane, centreOfMass(halfPlane, shares));
  for (Complex& z : circle)
  {
    z /= std::abs(z);
  }
  return combinations.extended(circle);
}

// The map after all vertices have been moved by a Moebius map. The centre lies close to the boundary
// vertex @p nearest: distances from it keep their digits if it is the origin of the first map, and
// infinity in the half-plane.
ComplexVector centredByAll(const ConvexCombinations& combinations,
  const std::vector<int>& loop,
  const Eigen::VectorXd& angles,
  Eigen::Index nearest,
  const DiskCentring& centring)
{
  Eigen::VectorXd rotated = angles.array() - angles[nearest];
  rotated = (rotated.array() < 0.0).select(rotated.array() + 2.0 * EIGEN_PI, rotated);
  ComplexVector boundary(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    boundary[k] = Complex(0.0, 2.0 * std::sin(0.5 * rotated[k])) * std::polar(1.0, 0.5 * rotated[k]);
  }
  ComplexVector halfPlane = combinations.extended(boundary);
  for (std::size_t v = 0; v < halfPlane.size(); ++v)
  {
    Complex& fromNearest = halfPlane[v];
    if (fromNearest == 0.0 && static_cast<int>(v) != loop[nearest])
    {
      throw ConvergenceError("vertex " + std::to_string(v) + " falls onto boundary vertex " +
                             std::to_string(loop[nearest]) +
                             ": the surface is too coarse there; set Method to Ricci Flow, or remesh "
                             "the surface (Surface To Disk, Remesh)");
    }
    fromNearest = Complex(0.0, -1.0) * (2.0 + fromNearest) / fromNearest;
  }
  const ComplexVector line = halfPlaneBoundary(rotated);
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    halfPlane[loop[k]] = line[k];
  }
  ComplexVector disk = cayley(halfPlane, centring.centre(halfPlane));
  moveToCircle(loop, disk);
  return disk;
}

ComplexVector centred(const ConvexCombinations& combinations,
  const std::vector<int>& loop,
  const Eigen::VectorXd& angles,
  const DiskCentring& centring)
{
  const Eigen::VectorXd shares = combinations.boundaryShares(centring.weights());
  Eigen::Index nearest = 0;
  return shares.maxCoeff(&nearest) < GreatestShare
           ? centredByBoundary(combinations, angles, shares)
           : centredByAll(combinations, loop, angles, nearest, centring);
}

} // namespace

ComplexVector convexCombinationDisk(const std::vector<NeighbourWeight>& weights,
  WeightSymmetry symmetry,
  const std::vector<int>& loop,
  const Eigen::VectorXd& angles,
  const DiskCentring& centring,
  const ProgressCallback& progress)
{
  const ConvexCombinations combinations(weights, symmetry, loop, centring.weights().size(), progress);
  ComplexVector disk = centred(combinations, loop, angles, centring);
  if (centring.vertex() >= 0)
  {
    disk[centring.vertex()] = 0.0; // it is there, but for rounding
  }
  for (const Complex& z : disk)
  {
    if (!std::isfinite(z.real()) || !std::isfinite(z.imag()))
    {
      throw ConvergenceError(
        "a vertex has no position in the disk: remesh the surface (Surface To Disk, "
        "Remesh)");
    }
  }
  return disk;
}

} // namespace flattening
